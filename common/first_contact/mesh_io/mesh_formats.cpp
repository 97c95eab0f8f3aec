#include "first_contact/mesh_io/mesh_formats.hpp"

#include <charconv>
#include <cmath>

namespace first_contact {
namespace {

constexpr std::string_view white_space = " \t\r\f\v";

// Whole word or nothing. A sign "+" is legal in the formats, but not to std::from_chars.
template <class Number>
bool parse(std::string_view word, Number& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

}  // namespace

void MeshBytes::reached(std::size_t byte) const {
  if (!progress || byte < next_to_tell_) return;
  progress(static_cast<double>(byte) / static_cast<double>(bytes.size()));
  next_to_tell_ = byte + bytes.size() / 100 + 1;
}

void MeshBytes::refuse_line(std::size_t line, const std::string& rule) const {
  throw MeshFileError(name + ", line " + std::to_string(line) + ": " + rule);
}

void MeshBytes::refuse_byte(std::size_t byte, const std::string& rule) const {
  throw MeshFileError(name + ", byte " + std::to_string(byte) + ": " + rule);
}

bool TextLines::next() {
  const std::string_view text = file_.bytes;
  file_.reached(position_);
  words_.clear();
  while (words_.empty() && position_ < text.size()) {
    const std::size_t end = std::min(text.find('\n', position_), text.size());
    std::string_view rest = text.substr(position_, end - position_);
    position_ = std::min(end + 1, text.size());
    ++line_;
    if (comment_ != '\0') rest = rest.substr(0, rest.find(comment_));
    for (std::size_t begin; (begin = rest.find_first_not_of(white_space)) != std::string_view::npos;) {
      const std::size_t length = std::min(rest.find_first_of(white_space, begin), rest.size()) - begin;
      words_.push_back(rest.substr(begin, length));
      rest.remove_prefix(begin + length);
    }
  }
  return !words_.empty();
}

void TextLines::require_next(const std::string& missing) {
  if (!next()) refuse("the file ends early: " + missing);
}

double TextLines::number(std::size_t i) const {
  if (i >= words_.size()) refuse("a number is missing after \"" + std::string(words_.back()) + "\"");
  double value = 0;
  if (!parse(words_[i], value) || !std::isfinite(value))
    refuse("\"" + std::string(words_[i]) + "\": must be a finite number");
  return value;
}

std::int64_t TextLines::whole(std::string_view word) const {
  std::int64_t value = 0;
  if (!parse(word, value)) refuse("\"" + std::string(word) + "\": must be a whole number");
  return value;
}

Point TextLines::point(std::size_t i) const { return {number(i), number(i + 1), number(i + 2)}; }

void add_fan(std::vector<Mesh::Face>& faces, const std::vector<std::uint32_t>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i) faces.push_back({polygon[0], polygon[i - 1], polygon[i]});
}

}  // namespace first_contact
