#include "first_contact/mesh_io/mesh_bytes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "first_contact/files/printable.hpp"

namespace first_contact {
namespace {

using namespace std::string_view_literals;

// What packed files begin with.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> packings{
    {{"\x1f\x8b"sv, "gzip"},
     {"PK\3\4"sv, "zip"},
     {"BZh"sv, "bzip2"},
     {"\xFD"
      "7zXZ"sv,
      "xz"},
     {"\x28\xB5\x2F\xFD"sv, "zstd"}}};

// Letters of ASCII in UTF-16 have every other byte 0, after a mark or without one.
bool is_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv)) return true;
  if (bytes.size() < 8) return false;
  const auto zeros = [&](std::size_t first) {
    return bytes[first] == 0 && bytes[first + 2] == 0 && bytes[first + 4] == 0 && bytes[first + 6] == 0;
  };
  return zeros(0) != zeros(1);
}

}  // namespace

void MeshBytes::reached(std::size_t byte) const {
  if (!progress || byte < next_to_tell_) return;
  progress(static_cast<double>(byte) / static_cast<double>(bytes.size()));
  next_to_tell_ = byte + bytes.size() / 100 + 1;
}

void MeshBytes::refuse_line(std::size_t line, const std::string& rule) const {
  throw MeshFileError(printable(name) + ", line " + std::to_string(line) + ": " + rule);
}

void MeshBytes::refuse_byte(std::size_t byte, const std::string& rule) const {
  throw MeshFileError(printable(name) + ", byte " + std::to_string(byte) + ": " + rule);
}

void MeshBytes::refuse_wrappings() const {
  for (const auto& [begin, packing] : packings)
    if (bytes.starts_with(begin))
      throw MeshFileError(printable(name) + ": is packed (" + std::string(packing) +
                          "), must be unpacked first");
  if (is_utf16(bytes))
    throw MeshFileError(printable(name) + ": is text in UTF-16, must be in UTF-8 or ASCII");
}

std::string in_quotes(std::string_view word) { return "\"" + printable(word) + "\""; }

}  // namespace first_contact
