#include "first_contact/files/output.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <utility>

namespace first_contact {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_writing(const fs::path& file, const std::error_code& error) {
  throw FileError(file, "cannot be written" + (error ? " (" + error.message() + ")" : std::string()));
}

[[noreturn]] void refuse_making(const fs::path& folder, const std::error_code& error) {
  throw FileError(folder, "cannot be made (" + error.message() + ")");
}

std::error_code last_error() { return {errno, std::generic_category()}; }

// Open files appear under these names: links, but to what has no name of its own, or another already.
bool names_an_open_file(const fs::path& file) {
  const std::string name = file.lexically_normal().generic_string();
  const bool of_a_process = name.starts_with("/proc/") && name.find("/fd/") != std::string::npos;
  return of_a_process || name.starts_with("/dev/fd/") || name == "/dev/stdout" || name == "/dev/stderr";
}

// Where a chain of symbolic links ends, also if nothing is there.
fs::path followed(const fs::path& file) {
  std::error_code error;
  fs::path end = fs::absolute(file, error);
  if (error) refuse_writing(file, error);
  for (int links = 0; !names_an_open_file(end) && fs::is_symlink(fs::symlink_status(end, error)); ++links) {
    if (links == 40) refuse_writing(file, std::make_error_code(std::errc::too_many_symbolic_link_levels));
    end = end.parent_path() / fs::read_symlink(end, error);
    if (error) refuse_writing(file, error);
  }
  return end;
}

void write_stream(std::FILE* stream, const fs::path& file, std::string_view content) {
  errno = 0;
  if (std::fwrite(content.data(), 1, content.size(), stream) != content.size() || std::fflush(stream) != 0)
    refuse_writing(file, last_error());
}

void write_to(const fs::path& place, std::ios::openmode mode, const fs::path& file,
              std::string_view content) {
  errno = 0;
  std::ofstream out(place, std::ios::binary | mode);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) refuse_writing(file, last_error());
}

// A file beside its target, gone at the end unless it has taken the target's place.
class Aside {
 public:
  explicit Aside(const fs::path& target) : path_(target.parent_path() / name()) {}
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;
  ~Aside() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
  }

  const fs::path& path() const { return path_; }

  std::error_code take_place_of(const fs::path& target) {
    std::error_code error;
    fs::rename(path_, target, error);
    if (!error) path_.clear();
    return error;
  }

 private:
  static std::string name() {
    std::random_device random;
    const std::uint64_t number = std::uint64_t{random()} << 32U | random();
    return ".first-contact-" + std::to_string(number) + ".part";
  }

  fs::path path_;
};

// That another file may be made beside this one.
void require_room_beside(const fs::path& target, const fs::path& file) {
  const Aside aside(target);
  write_to(aside.path(), std::ios::trunc, file, "");
}

// That a plain file may be replaced does not mean that it may be written.
void require_opened(const fs::path& target, const fs::path& file) {
  errno = 0;
  if (!std::ofstream(target, std::ios::binary | std::ios::app)) refuse_writing(file, last_error());
}

void replace(const fs::path& target, const fs::path& file, std::string_view content, bool exists) {
  if (exists) require_opened(target, file);
  Aside aside(target);
  write_to(aside.path(), std::ios::trunc, file, content);
  std::error_code error;
  if (exists) fs::permissions(aside.path(), fs::status(target, error).permissions(), error);
  if (!error) error = aside.take_place_of(target);
  if (error) refuse_writing(file, error);
}

struct Target {
  fs::path path;
  bool exists;
  bool replaceable;  // a plain file, or none yet
};

Target target_of(const fs::path& file) {
  if (file.empty()) throw FileError(file, "must be a file with a name");
  const fs::path path = followed(file);
  if (names_an_open_file(path)) return {path, true, false};
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::none) refuse_writing(file, error);
  if (fs::is_directory(status)) throw FileError(file, "must be a file, not a folder");
  return {path, fs::exists(status), !fs::exists(status) || fs::is_regular_file(status)};
}

// A folder, or the nearest above it that is there. A name that is too long or a link that leads nowhere, or
// in a loop, is not passed by: no folder could be made there.
fs::path nearest_above(const fs::path& folder) {
  std::error_code error;
  fs::path place = fs::absolute(folder, error);
  if (error) refuse_making(folder, error);
  for (; place.has_relative_path(); place = place.parent_path()) {
    const fs::file_type type = fs::status(place, error).type();
    if (type == fs::file_type::none) refuse_making(folder, error);
    if (type != fs::file_type::not_found) break;
    if (fs::is_symlink(fs::symlink_status(place, error)))
      refuse_making(folder, std::make_error_code(std::errc::no_such_file_or_directory));
  }
  return place;
}

}  // namespace

void write_file(const fs::path& file, std::string_view content) {
  const Target target = target_of(file);
  if (target.path == "/dev/stdout") return write_stream(stdout, file, content);
  if (target.path == "/dev/stderr") return write_stream(stderr, file, content);
  if (!target.replaceable) return write_to(target.path, std::ios::app, file, content);
  replace(target.path, file, content, target.exists);
}

void require_writable(const fs::path& file) {
  const Target target = target_of(file);
  if (!target.replaceable) return;  // a pipe may wait for its reader
  if (target.exists) require_opened(target.path, file);
  require_room_beside(target.path, file);
}

void make_folder(const fs::path& folder) {
  std::error_code error, ignored;
  fs::create_directories(folder, error);
  if (fs::is_directory(folder, ignored)) return;
  refuse_making(folder, error ? error : std::make_error_code(std::errc::not_a_directory));
}

void require_folder(const fs::path& folder) {
  const fs::path there = nearest_above(folder);
  std::error_code ignored;
  if (!fs::is_directory(there, ignored))
    refuse_making(folder, std::make_error_code(std::errc::not_a_directory));
  require_room_beside(there / "a", folder);
}

}  // namespace first_contact
