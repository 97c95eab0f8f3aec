#pragma once
#include <concepts>
#include <ostream>
#include <string>
#include <vector>

#include "first_contact/geometry/space.hpp"
#include "first_contact/program/language.hpp"

namespace first_contact::program {

/// A number for a reader: six significant digits, and no minus before a zero.
/// \throws std::invalid_argument for what is not a number: nothing is shown that means nothing.
std::string readable(double value);
/// A vector for a reader: (1, -2, 0.5).
std::string readable(const Vector& value);
std::string readable(const std::string& value);
/// A count for a reader: all of its digits.
template <std::integral Whole>
std::string readable(Whole value) {
  return std::to_string(value);
}
/// A number with the text by which a reader sees it.
struct Shown {
  double number;     ///< what it is
  std::string text;  ///< how it is shown
};
inline std::string readable(const Shown& value) { return value.text; }

/// The report that a student follows: a title, then rows of symbol, value and meaning, with the paper's
/// equation and printed value where there are any. It is printed whole at the end.
class Report {
 public:
  /// An empty report in that language.
  explicit Report(Language language) : language_(language) {}

  /// The first line: what the chapter is about, and the paper's section.
  void title(const Text& text, const std::string& section);
  /// A heading or a sentence between rows; an empty line before it.
  void say(const Text& text);
  /// A sentence that follows directly on what stands before.
  void also(const Text& text);
  /// One number: the paper's symbol or equation, the value, what it means.
  template <class Value>
  void row(const std::string& equation, const Value& value, const Text& meaning) {
    lines_.push_back({equation, readable(value), meaning.in(language_), true});
  }
  /// One number that the paper prints, beside it.
  template <class Value>
  void row(const std::string& equation, const Value& value, const Text& meaning, const std::string& printed) {
    const Text note{"the paper prints ", "論文印作 "};
    row(equation, value,
        Text{meaning.english + "; " + note.english + printed,
             meaning.chinese + "；" + note.chinese + printed});
  }

  /// Prints all of it, the columns aligned.
  void print(std::ostream& out) const;

 private:
  struct Line {
    std::string equation, value, meaning;
    bool is_row;
  };

  Language language_;
  std::vector<Line> lines_;
};

}  // namespace first_contact::program
