#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "first_contact/mesh_io/text_lines.hpp"

/// \file
/// What the header of a PLY file says: how the rest is written, and what it holds.

namespace first_contact::ply {

/// A type of numbers.
struct Type {
  /// With a sign, without, floating.
  enum Kind { whole, natural, real };
  Kind kind;       ///< which of them
  unsigned bytes;  ///< that it has in a binary file
};

/// A number of an element, or a list of numbers.
struct Property {
  std::string name;           ///< such as x
  Type type;                  ///< of the number, or of each in the list
  std::optional<Type> count;  ///< of the list's length; nothing for a single number
};

/// Rows that all have the same properties.
struct Element {
  std::string name;                  ///< such as vertex
  std::int64_t count;                ///< of rows
  std::vector<Property> properties;  ///< in their order
};

/// How numbers are written.
enum class Encoding { ascii, little_endian, big_endian };

/// All that the header says.
struct Header {
  Encoding encoding;              ///< of all rows
  std::vector<Element> elements;  ///< in their order
};

/// Reads from "ply" to "end_header".
/// \throws MeshFileError for what is no header, or names an element or a property of one element twice.
Header read_header(TextLines& lines);

}  // namespace first_contact::ply
