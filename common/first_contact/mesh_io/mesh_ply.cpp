#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "first_contact/mesh_io/mesh_formats.hpp"
#include "first_contact/mesh_io/ply_header.hpp"

namespace first_contact {
namespace {

using namespace ply;

// The values of an ASCII file: one element a line.
class TextValues {
 public:
  explicit TextValues(TextLines& lines) : lines_(lines) {}
  void begin_row(const std::string& missing) { lines_.require_next(missing), word_ = 0; }
  double next(const Type&) { return lines_.any_number(word_++); }
  void end_row() const {
    if (word_ < lines_.words().size())
      refuse("the line must end after " + std::to_string(word_) + " numbers");
  }
  void end_file() const {
    if (lines_.next()) refuse("more follows than the counts promise");
  }
  std::size_t place() const { return lines_.line(); }
  [[noreturn]] void refuse(const std::string& rule) const { lines_.refuse(rule); }

 private:
  TextLines& lines_;
  std::size_t word_ = 0;
};

// The values of a binary file, one after the other.
class BinaryValues {
 public:
  BinaryValues(const MeshBytes& file, std::size_t position, Encoding encoding)
      : file_(file), position_(position), last_(position), little_(encoding == Encoding::little_endian) {}
  void begin_row(const std::string& missing) {
    missing_ = missing;
    file_.reached(position_);
  }
  double next(const Type& type) {
    const std::uint64_t bits = read(type.bytes);
    if (type.kind == Type::natural) return static_cast<double>(bits);
    const unsigned unused = 64 - 8 * type.bytes;  // moved up and down again to spread the sign
    if (type.kind == Type::whole)
      return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
    return type.bytes == 8 ? std::bit_cast<double>(bits)
                           : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  }
  void end_row() const {}
  std::size_t place() const { return last_; }
  void end_file() const {
    if (position_ < file_.bytes.size()) file_.refuse_byte(position_, "more follows than the counts promise");
  }
  [[noreturn]] void refuse(const std::string& rule) const { file_.refuse_byte(last_, rule); }

 private:
  std::uint64_t read(std::size_t bytes) {
    last_ = position_;
    if (file_.bytes.size() - position_ < bytes) refuse("the file ends early: " + missing_);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      const std::size_t at = position_ + (little_ ? bytes - 1 - i : i);  // the highest byte first
      bits = bits << 8 | static_cast<unsigned char>(file_.bytes[at]);
    }
    position_ += bytes;
    return bits;
  }

  const MeshBytes& file_;
  std::size_t position_, last_;
  bool little_;
  std::string missing_;
};

// What is wanted of a row.
struct Row {
  std::array<std::optional<double>, 3> position;
  std::vector<double> corners;
};

template <class Values>
std::uint32_t read_count(Values& values, const Property& property) {
  if (!property.count) return 1;
  constexpr double most =
      std::numeric_limits<std::uint32_t>::max();  // the widest type that a list's length can have
  const double count = values.next(*property.count);
  if (!(count >= 0 && count <= most) || count != std::floor(count))
    values.refuse("a list must have a whole number of items");
  return static_cast<std::uint32_t>(count);
}

// Reads one row; the others' numbers may be anything.
template <class Values>
Row read_row(Values& values, const Element& element) {
  Row row;
  for (const Property& property : element.properties) {
    const bool corners = property.count && property.name == "vertex_indices";
    const bool coordinate = element.name == "vertex" && !property.count && property.name.size() == 1 &&
                            property.name >= "x" && property.name <= "z";
    for (std::uint32_t left = read_count(values, property); left > 0; --left) {
      const double value = values.next(property.type);
      if (corners) row.corners.push_back(value);
      if (coordinate && !std::isfinite(value)) values.refuse("a coordinate must be a finite number");
      if (coordinate) row.position[static_cast<std::size_t>(property.name[0] - 'x')] = value;
    }
  }
  values.end_row();
  return row;
}

template <class Values>
std::uint32_t corner_of(const Values& values, double corner, std::int64_t vertices) {
  if (!(corner >= 0 && corner < static_cast<double>(vertices)) || corner != std::floor(corner))
    values.refuse("a vertex of a face must be a whole number from 0 to below " + std::to_string(vertices));
  return static_cast<std::uint32_t>(corner);
}

template <class Values>
void read_face(const Values& values, const Row& row, std::int64_t vertices, Polygons& faces) {
  if (row.corners.size() < 3) values.refuse("a face must have a list vertex_indices of at least 3 corners");
  std::vector<std::uint32_t> polygon;
  for (const double corner : row.corners) polygon.push_back(corner_of(values, corner, vertices));
  faces.add(polygon, values.place());
}

// Strips of triangles, each of which shares an edge with the one before it; -1 ends a strip. Every other
// triangle turns the other way; one with a corner twice only leads on.
template <class Values>
void read_strips(const Values& values, const Row& row, std::int64_t vertices, Polygons& faces) {
  std::vector<std::uint32_t> strip;
  for (const double corner : row.corners) {
    if (corner == -1) {
      strip.clear();
      continue;
    }
    strip.push_back(corner_of(values, corner, vertices));
    if (strip.size() < 3) continue;
    std::array<std::uint32_t, 3> triangle{strip.end()[-3], strip.end()[-2], strip.end()[-1]};
    if (strip.size() % 2 == 0) std::swap(triangle[0], triangle[1]);
    const auto [a, b, c] = triangle;
    if (a != b && b != c && c != a) faces.add(triangle, values.place());
  }
}

std::int64_t count_of(const std::vector<Element>& elements, std::string_view name) {
  for (const Element& element : elements)
    if (element.name == name) return element.count;
  return 0;
}

template <class Values>
RawMesh read_elements(Values values, const std::vector<Element>& elements) {
  RawMesh mesh;
  const std::int64_t vertices = count_of(elements, "vertex");
  for (const Element& element : elements)
    for (std::int64_t i = 0; i < element.count; ++i) {
      values.begin_row(std::to_string(i) + " of " + std::to_string(element.count) + " rows of " +
                       element.name);
      const Row row = read_row(values, element);
      const auto& [x, y, z] = row.position;
      if (element.name == "vertex" && !(x && y && z)) values.refuse("a vertex must have x, y and z");
      if (element.name == "vertex") mesh.vertices.emplace_back(*x, *y, *z);
      if (element.name == "face") read_face(values, row, vertices, mesh.faces);
      if (element.name == "tristrips") read_strips(values, row, vertices, mesh.faces);
    }
  values.end_file();
  return mesh;
}

}  // namespace

RawMesh read_ply(const MeshBytes& file) {
  file.refuse_wrappings();
  TextLines lines(file);
  const Header header = read_header(lines);
  if (header.encoding == Encoding::ascii) return read_elements(TextValues(lines), header.elements);
  return read_elements(BinaryValues(file, lines.position(), header.encoding), header.elements);
}

}  // namespace first_contact
