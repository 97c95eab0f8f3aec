#include <bit>
#include <cmath>
#include <span>

#include "first_contact/geometry/weld.hpp"
#include "first_contact/mesh_io/mesh_formats.hpp"
#include "first_contact/mesh_io/text_lines.hpp"

namespace first_contact {
namespace {

// STL repeats each corner in every triangle: equal positions become one vertex, in the order of their first.
RawMesh mesh_of(const std::vector<Point>& corners) {
  const std::vector<std::uint32_t> lowest = welded(corners);
  RawMesh mesh;
  std::vector<std::uint32_t> number(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool is_new = lowest[i] == i;
    number[i] = is_new ? static_cast<std::uint32_t>(mesh.vertices.size()) : number[lowest[i]];
    if (is_new) mesh.vertices.push_back(corners[i]);
  }
  for (std::size_t i = 0; i < corners.size(); i += 3) mesh.faces.add(std::span(number).subspan(i, 3), i / 3);
  return mesh;
}

// A word of STL in small letters: both are in use.
std::string lower(std::string_view word) {
  std::string letters(word);
  for (char& letter : letters)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return letters;
}

// The lines facet, outer loop, vertex (three), endloop, endfacet, between solid and endsolid. The normal of a
// facet is not read: it follows from the corners.
RawMesh read_text(const MeshBytes& file) {
  std::vector<Point> corners;
  std::size_t in_loop = 0;
  bool open = false;  // between solid and endsolid
  TextLines lines(file);
  while (lines.next()) {
    const std::string word = lower(lines.words()[0]);
    if (!open && word != "solid")
      lines.refuse(in_quotes(lines.words()[0]) +
                   ": must be solid: a text begins with it, and so does each of its parts");
    if (open && word == "solid") lines.refuse("solid and endsolid must alternate");
    if (word == "vertex") {
      corners.push_back(lines.point(1));
      ++in_loop;
    } else if (word == "endloop") {
      if (in_loop != 3) lines.refuse("a facet must have 3 vertices");
      in_loop = 0;
    } else if (word == "solid" || word == "endsolid") {
      open = word == "solid";
    } else if (word != "facet" && word != "outer" && word != "endfacet") {
      lines.refuse(in_quotes(lines.words()[0]) + ": must be a line of an STL file");
    }
    if (!open && in_loop > 0) lines.refuse("the last facet is not complete");
  }
  if (open) lines.refuse("the file ends early: endsolid is missing");
  return mesh_of(corners);
}

std::uint32_t word_at(const MeshBytes& file, std::size_t byte) {  // little-endian
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(file.bytes[byte + i]);
  return value;
}

Point point_at(const MeshBytes& file, std::size_t byte) {
  Point p;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = std::bit_cast<float>(word_at(file, byte + 4 * i));
    if (!std::isfinite(value)) file.refuse_byte(byte + 4 * i, "must be a finite number");
    p[static_cast<Eigen::Index>(i)] = value;
  }
  return p;
}

// 80 bytes of any kind, the count, and for each triangle 50 bytes: its normal, three corners, two bytes more.
constexpr std::size_t header = 84, record = 50;

bool fills_its_count(const MeshBytes& file) {
  return file.bytes.size() >= header && file.bytes.size() - header == record * std::size_t{word_at(file, 80)};
}

RawMesh read_binary(const MeshBytes& file) {
  if (file.bytes.size() < header)
    file.refuse_byte(file.bytes.size(), "the file ends early: STL has 84 bytes of header");
  if (!fills_its_count(file)) {
    const std::size_t count = word_at(file, 80), have = file.bytes.size() - header;
    file.refuse_byte(80, std::to_string(count) + " triangles need " + std::to_string(record * count) +
                             " bytes after the header, not " + std::to_string(have));
  }
  std::vector<Point> corners;
  for (std::size_t byte = header + 12; byte < file.bytes.size(); byte += record) {
    file.reached(byte);
    for (std::size_t corner = 0; corner < 3; ++corner) corners.push_back(point_at(file, byte + 12 * corner));
  }
  return mesh_of(corners);
}

// Text has no byte 0, unless behind its end; what is binary has one in its count, or its
// numbers, at the latest.
bool is_text(const MeshBytes& file) { return file.bytes.find('\0') >= file.bytes.rfind("endsolid"); }

}  // namespace

RawMesh read_stl(const MeshBytes& file) {
  // Binary files, too, may begin with "solid", and what is packed may look like a binary one: the size tells.
  if (fills_its_count(file)) return read_binary(file);
  file.refuse_wrappings();
  return is_text(file) ? read_text(file) : read_binary(file);
}

}  // namespace first_contact
