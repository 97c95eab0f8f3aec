#include "first_contact/program/mesh_loading.hpp"

#include <cstdio>
#include <string>
#include <utility>

#include "first_contact/mesh_io/mesh_file.hpp"

#if __has_include(<unistd.h>)
#include <unistd.h>
#else
#include <io.h>
#endif

namespace first_contact::program {

namespace {

constexpr std::uintmax_t large = 4 << 20;  // bytes: what is read in less time than one notices

// One line of a terminal, written again and again, and wiped at the end.
class ProgressLine {
 public:
  explicit ProgressLine(std::string name) : name_(std::move(name)) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { std::fputs("\r\033[K", stderr); }

  void show(double part) const { std::fprintf(stderr, "\r%s: %3.0f %% read", name_.c_str(), 100 * part); }

 private:
  std::string name_;
};

bool standard_error_is_a_terminal() {
#if __has_include(<unistd.h>)
  return isatty(STDERR_FILENO) != 0;
#else
  return _isatty(_fileno(stderr)) != 0;
#endif
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& file) {
  std::error_code unknown;  // what cannot be asked cannot be read either, and read_mesh says so
  const auto bytes = std::filesystem::file_size(file, unknown);
  if (unknown || bytes < large || !standard_error_is_a_terminal()) return read_mesh(file);
  const ProgressLine line(file.filename().string());
  return read_mesh(file, [&](double part) { line.show(part); });
}

}  // namespace first_contact::program
