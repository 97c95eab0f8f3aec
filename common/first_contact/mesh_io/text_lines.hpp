#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "first_contact/geometry/space.hpp"
#include "first_contact/mesh_io/mesh_bytes.hpp"

namespace first_contact {

/// The words of a text, line by line. A line ends as the first one does: with a line feed, a carriage return,
/// or both.
class TextLines {
 public:
  /// How a format is written.
  struct Style {
    char comment =
        '\0';  ///< what follows this character is not read, up to the end of the line; '\0' for none
    bool continues = false;  ///< a line that ends in a backslash goes on in the next one, with another word
  };

  /// Nothing of the text is read yet.
  explicit TextLines(const MeshBytes& file, Style style);
  /// A format without comments.
  explicit TextLines(const MeshBytes& file) : TextLines(file, Style()) {}

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

  /// Word i as a number, which may be infinite or none.
  double any_number(std::size_t i) const;
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
  std::string_view raw_line();
  bool take_words(std::string_view rest);

  const MeshBytes& file_;
  Style style_;
  char line_end_;
  std::size_t position_;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace first_contact
