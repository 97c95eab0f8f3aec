#include "first_contact/mesh_io/text_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "first_contact/files/decimal.hpp"

namespace first_contact {
namespace {

constexpr std::string_view white_space = " \t\r\n\f\v";

char line_end_of(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  const bool carriage_alone = end != text.npos && text[end] == '\r' && text.substr(end, 2) != "\r\n";
  return carriage_alone ? '\r' : '\n';
}

// A sign "+" is legal in the formats.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

}  // namespace

TextLines::TextLines(const MeshBytes& file, Style style)
    : file_(file), style_(style), line_end_(line_end_of(file.bytes)), position_(0) {}

bool TextLines::next() {
  file_.reached(position_);
  words_.clear();
  while (words_.empty() && position_ < file_.bytes.size())
    while (take_words(raw_line()))
      if (position_ == file_.bytes.size()) refuse("the file ends early: a line follows a backslash");
  return !words_.empty();
}

// Without a byte order mark: one stands at the beginning, and where files were put together,
// before each of them.
std::string_view TextLines::raw_line() {
  const std::string_view text = file_.bytes, mark = "\xEF\xBB\xBF";
  std::size_t begin = position_;
  while (text.substr(begin).starts_with(mark)) begin += mark.size();
  const std::size_t end = std::min(text.find(line_end_, begin), text.size());
  position_ = std::min(end + 1, text.size());
  ++line_;
  return text.substr(begin, end - begin);
}

// Is the line to be continued?
bool TextLines::take_words(std::string_view rest) {
  if (style_.comment != '\0') rest = rest.substr(0, rest.find(style_.comment));
  rest = rest.substr(0, rest.find_last_not_of(white_space) + 1);
  const bool continued = style_.continues && rest.ends_with('\\');
  if (continued) rest.remove_suffix(1);
  for (std::size_t begin; (begin = rest.find_first_not_of(white_space)) != std::string_view::npos;) {
    const std::size_t length = std::min(rest.find_first_of(white_space, begin), rest.size()) - begin;
    words_.push_back(rest.substr(begin, length));
    rest.remove_prefix(begin + length);
  }
  return continued;
}

void TextLines::require_next(const std::string& missing) {
  if (!next()) refuse("the file ends early: " + missing);
}

double TextLines::any_number(std::size_t i) const {
  if (i >= words_.size()) refuse("a number is missing after " + in_quotes(words_.back()));
  const auto value = decimal(without_plus(words_[i]));
  if (!value) refuse(in_quotes(words_[i]) + ": must be a number");
  return *value;
}

double TextLines::number(std::size_t i) const {
  const double value = any_number(i);
  if (!std::isfinite(value)) refuse(in_quotes(words_[i]) + ": must be a finite number");
  return value;
}

std::int64_t TextLines::whole(std::string_view word) const {
  std::int64_t value = 0;
  const std::string_view digits = without_plus(word);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size())
    refuse(in_quotes(word) + ": must be a whole number");
  return value;
}

Point TextLines::point(std::size_t i) const { return {number(i), number(i + 1), number(i + 2)}; }

}  // namespace first_contact
