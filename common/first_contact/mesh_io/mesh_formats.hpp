#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/mesh_io/mesh_file.hpp"

/// \file
/// What the readers of the mesh formats share. Programs include mesh_file.hpp instead.

namespace first_contact {

/// A mesh file in memory: its name, for messages, and all its bytes.
struct MeshBytes {
  /// The file's name.
  std::string name;
  /// All that is in it.
  std::string bytes;
  /// Whom to tell how far the reading is; nobody if it is empty.
  ReadingProgress progress = {};

  /// Readers say here that they have come to this byte; those who listen hear of every hundredth part.
  void reached(std::size_t byte) const;

  /// \throws MeshFileError "name, line 7: rule".
  [[noreturn]] void refuse_line(std::size_t line, const std::string& rule) const;
  /// \throws MeshFileError "name, byte 84: rule".
  [[noreturn]] void refuse_byte(std::size_t byte, const std::string& rule) const;

 private:
  mutable std::size_t next_to_tell_ = 0;
};

/// Wavefront OBJ.
/// \throws MeshFileError
Mesh read_obj(const MeshBytes& file);
/// OFF.
/// \throws MeshFileError
Mesh read_off(const MeshBytes& file);
/// PLY, in ASCII or binary.
/// \throws MeshFileError
Mesh read_ply(const MeshBytes& file);
/// STL, in ASCII or binary.
/// \throws MeshFileError
Mesh read_stl(const MeshBytes& file);

/// The words of a text, line by line.
class TextLines {
 public:
  /// \param comment  what follows this character is not read, up to the end of the line; '\0' for none.
  explicit TextLines(const MeshBytes& file, char comment = '\0') : file_(file), comment_(comment) {}

  /// Goes on to the next line that has a word; false at the end of the text.
  bool next();
  /// Goes on to the next line that has a word, or refuses the file with `missing`.
  void require_next(const std::string& missing);

  /// The words of this line.
  const std::vector<std::string_view>& words() const { return words_; }
  /// The number of the line, from 1.
  std::size_t line() const { return line_; }
  /// The byte that follows the line.
  std::size_t position() const { return position_; }

  /// Word i as a finite number.
  double number(std::size_t i) const;
  /// A word of this line as a whole number.
  std::int64_t whole(std::string_view word) const;
  /// Words i, i + 1, i + 2 as a point.
  Point point(std::size_t i) const;
  /// Refuses this line.
  /// \throws MeshFileError
  [[noreturn]] void refuse(const std::string& rule) const { file_.refuse_line(line_, rule); }

 private:
  const MeshBytes& file_;
  char comment_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
};

/// Cuts a polygon of three or more corners into the triangles of a fan from its first corner.
void add_fan(std::vector<Mesh::Face>& faces, const std::vector<std::uint32_t>& polygon);

}  // namespace first_contact
