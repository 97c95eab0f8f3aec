#include "first_contact/files/input.hpp"

#include <array>
#include <cerrno>
#include <fstream>
#include <new>
#include <system_error>

namespace first_contact {
namespace {

namespace fs = std::filesystem;

std::string reason() { return errno == 0 ? "" : " (" + std::generic_category().message(errno) + ")"; }

std::string all_of(std::istream& in, const fs::path& file, std::size_t most) {
  std::error_code ignored;
  const bool ends = fs::is_regular_file(file, ignored);
  std::string bytes;
  std::array<char, 1 << 16> part;
  while (in.read(part.data(), part.size()), in.gcount() > 0) {
    bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
    if (!ends && bytes.size() > most)
      throw FileError(file, "must end within " + std::to_string(most) + " bytes");
  }
  if (in.bad()) throw FileError(file, "cannot be read to its end" + reason());
  return bytes;
}

}  // namespace

std::string read_file(const fs::path& file, std::size_t most) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) throw FileError(file, "must be a file, not a folder");
  if (file.native().find(fs::path::value_type{}) !=
      fs::path::string_type::npos)  // the system would read up to there
    throw FileError(file, "must be a file that exists and can be read");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError(file, "must be a file that exists and can be read" + reason());
  try {
    return all_of(in, file, most);
  } catch (const std::bad_alloc&) {
    throw FileError(file, "needs more memory than there is");
  }
}

std::string without_byte_order_mark(std::string text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return text;
}

}  // namespace first_contact
