#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "first_contact/mesh_io/read_mesh.hpp"

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
  /// Names what the file is instead, if that can be seen: packed, or text in UTF-16.
  /// \throws MeshFileError if it is.
  void refuse_wrappings() const;

 private:
  mutable std::size_t next_to_tell_ = 0;
};

/// A word of a file as a message quotes it.
std::string in_quotes(std::string_view word);

}  // namespace first_contact
