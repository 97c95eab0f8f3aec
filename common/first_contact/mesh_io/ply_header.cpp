#include "first_contact/mesh_io/ply_header.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace first_contact::ply {
namespace {

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
  lines.refuse(in_quotes(word) + ": must be a type of PLY");
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

template <class Named>
void add(const TextLines& lines, std::vector<Named>& all, Named one) {
  for (const Named& other : all)
    if (other.name == one.name) lines.refuse(in_quotes(one.name) + ": must be there only once");
  all.push_back(std::move(one));
}

// "element NAME COUNT", "property TYPE NAME" or "property list TYPE TYPE NAME".
void read_declaration(const TextLines& lines, std::vector<Element>& elements) {
  const auto& words = lines.words();
  const std::size_t size = words.size();
  const bool property = words[0] == "property" && !elements.empty();
  const auto name_of_list = [](std::string_view name) {  // both names are in use
    return std::string(name == "vertex_index" ? "vertex_indices" : name);
  };
  if (words[0] == "element" && size == 3) {
    add(lines, elements, {std::string(words[1]), lines.whole(words[2]), {}});
    if (elements.back().count < 0) lines.refuse("a count must not be negative");
  } else if (property && size == 3) {
    add(lines, elements.back().properties, {std::string(words[2]), read_type(lines, words[1]), {}});
  } else if (property && size == 5 && words[1] == "list") {
    add(lines, elements.back().properties,
        {name_of_list(words[4]), read_type(lines, words[3]), read_type(lines, words[2])});
  } else if (words[0] != "comment" && words[0] != "obj_info") {
    lines.refuse("must be an element, a property, a comment or end_header");
  }
}

}  // namespace

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

}  // namespace first_contact::ply
