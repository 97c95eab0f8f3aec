#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "first_contact/mesh_io/mesh_formats.hpp"

namespace first_contact {
namespace {

struct Type {
  enum Kind { whole, natural, real } kind;  // with a sign, without, floating
  unsigned bytes;
};

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  // a list has one
};

struct Element {
  std::string name;
  std::int64_t count;
  std::vector<Property> properties;
};

enum class Encoding { ascii, little_endian, big_endian };

struct Header {
  Encoding encoding;
  std::vector<Element> elements;
};

Type read_type(const TextLines& lines, std::string_view word) {
  struct Name {
    std::string_view old_name, new_name;
    Type type;
  };
  constexpr std::array<Name, 8> names{{{"char", "int8", {Type::whole, 1}},
                                       {"uchar", "uint8", {Type::natural, 1}},
                                       {"short", "int16", {Type::whole, 2}},
                                       {"ushort", "uint16", {Type::natural, 2}},
                                       {"int", "int32", {Type::whole, 4}},
                                       {"uint", "uint32", {Type::natural, 4}},
                                       {"float", "float32", {Type::real, 4}},
                                       {"double", "float64", {Type::real, 8}}}};
  for (const Name& name : names)
    if (word == name.old_name || word == name.new_name) return name.type;
  lines.refuse("\"" + std::string(word) + "\": must be a type of PLY");
}

Encoding read_encoding(const TextLines& lines) {
  const auto& words = lines.words();
  if (words.size() == 3 && words[0] == "format" && words[2] == "1.0") {
    if (words[1] == "ascii") return Encoding::ascii;
    if (words[1] == "binary_little_endian") return Encoding::little_endian;
    if (words[1] == "binary_big_endian") return Encoding::big_endian;
  }
  lines.refuse("must be format ascii, binary_little_endian or binary_big_endian 1.0");
}

// "element NAME COUNT", "property TYPE NAME" or "property list TYPE TYPE NAME".
void read_declaration(const TextLines& lines, std::vector<Element>& elements) {
  const auto& words = lines.words();
  const std::size_t size = words.size();
  if (words[0] == "element" && size == 3) {
    elements.push_back({std::string(words[1]), lines.whole(words[2]), {}});
    if (elements.back().count < 0) lines.refuse("a count must not be negative");
  } else if (words[0] == "property" && size == 3 && !elements.empty()) {
    elements.back().properties.push_back({std::string(words[2]), read_type(lines, words[1]), {}});
  } else if (words[0] == "property" && size == 5 && words[1] == "list" && !elements.empty()) {
    elements.back().properties.push_back(
        {std::string(words[4]), read_type(lines, words[3]), read_type(lines, words[2])});
  } else if (words[0] != "comment" && words[0] != "obj_info") {
    lines.refuse("must be an element, a property, a comment or end_header");
  }
}

Header read_header(TextLines& lines) {
  if (!lines.next() || lines.words()[0] != "ply") lines.refuse("must begin with ply");
  lines.require_next("the format is missing");
  Header header{read_encoding(lines), {}};
  while (lines.require_next("end_header is missing"), lines.words()[0] != "end_header")
    read_declaration(lines, header.elements);
  for (const Element& element : header.elements)
    if (element.properties.empty()) lines.refuse("element " + element.name + " must have a property");
  return header;
}

// The values of an ASCII file: one element a line.
class TextValues {
 public:
  explicit TextValues(TextLines& lines) : lines_(lines) {}
  void begin_row(const std::string& missing) { lines_.require_next(missing), word_ = 0; }
  double next(const Type&) { return lines_.number(word_++); }
  void end_row() const {
    if (word_ < lines_.words().size())
      refuse("the line must end after " + std::to_string(word_) + " numbers");
  }
  void end_file() const {
    if (lines_.next()) refuse("more follows than the counts promise");
  }
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
    const double value = type.bytes == 8 ? std::bit_cast<double>(bits)
                                         : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (!std::isfinite(value)) refuse("must be a finite number");
    return value;
  }
  void end_row() const {}
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

struct Row {
  std::array<std::optional<double>, 3> position;
  std::vector<double> corners;
};

template <class Values>
Row read_row(Values& values, const Element& element) {
  Row row;
  for (const Property& property : element.properties) {
    const double count = property.count ? values.next(*property.count) : 1;
    constexpr double most =
        std::numeric_limits<std::uint32_t>::max();  // the widest type that a list's length can have
    if (!(count >= 0 && count <= most) || count != std::floor(count))
      values.refuse("a list must have a whole number of items");
    const bool corners =
        property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
    for (auto left = static_cast<std::uint32_t>(count); left > 0; --left) {
      const double value = values.next(property.type);
      if (corners) row.corners.push_back(value);
      if (!property.count && property.name.size() == 1 && property.name >= "x" && property.name <= "z")
        row.position[static_cast<std::size_t>(property.name[0] - 'x')] = value;
    }
  }
  values.end_row();
  return row;
}

template <class Values>
std::vector<std::uint32_t> read_polygon(const Values& values, const Row& row, std::size_t vertices) {
  if (row.corners.size() < 3) values.refuse("a face must have a list vertex_indices of at least 3 corners");
  std::vector<std::uint32_t> polygon;
  for (const double corner : row.corners) {
    if (!(corner >= 0 && corner < static_cast<double>(vertices)) || corner != std::floor(corner))
      values.refuse("a vertex of a face must be a whole number from 0 to below " + std::to_string(vertices));
    polygon.push_back(static_cast<std::uint32_t>(corner));
  }
  return polygon;
}

template <class Values>
Mesh read_elements(Values values, const std::vector<Element>& elements) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const Element& element : elements)
    for (std::int64_t i = 0; i < element.count; ++i) {
      values.begin_row(std::to_string(i) + " of " + std::to_string(element.count) + " rows of " +
                       element.name);
      const Row row = read_row(values, element);
      const auto& [x, y, z] = row.position;
      if (element.name == "vertex" && !(x && y && z)) values.refuse("a vertex must have x, y and z");
      if (element.name == "vertex") vertices.emplace_back(*x, *y, *z);
      if (element.name == "face") add_fan(faces, read_polygon(values, row, vertices.size()));
    }
  values.end_file();
  return {std::move(vertices), std::move(faces)};
}

}  // namespace

Mesh read_ply(const MeshBytes& file) {
  TextLines lines(file);
  const Header header = read_header(lines);
  if (header.encoding == Encoding::ascii) return read_elements(TextValues(lines), header.elements);
  return read_elements(BinaryValues(file, lines.position(), header.encoding), header.elements);
}

}  // namespace first_contact
