#include "first_contact/program/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace first_contact::program {

std::string readable(double value) {
  if (std::isnan(value)) throw std::invalid_argument("must not lead to what is no number");
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value == 0 ? 0.0 : value);
  return text;
}
std::string readable(const Vector& value) {
  return "(" + readable(value.x()) + ", " + readable(value.y()) + ", " + readable(value.z()) + ")";
}
std::string readable(const std::string& value) { return value; }

void Report::title(const Text& text, const std::string& section) {
  const Text paper{"paper, ", "論文 "};
  lines_.push_back({text.in(language_) + "  (" + paper.in(language_) + section + ")", "", "", false});
}

void Report::say(const Text& text) {
  lines_.push_back({"", "", "", false});
  also(text);
}

void Report::also(const Text& text) { lines_.push_back({text.in(language_), "", "", false}); }

void Report::print(std::ostream& out) const {
  std::size_t equation_width = 0, value_width = 0;
  for (const Line& line : lines_) {
    if (!line.is_row) continue;
    equation_width = std::max(equation_width, columns(line.equation));
    value_width = std::max(value_width, columns(line.value));
  }
  for (const Line& line : lines_) {
    if (line.is_row)
      out << "  " << padded(line.equation, equation_width) << " = " << padded(line.value, value_width)
          << "   " << line.meaning << '\n';
    else
      out << line.equation << '\n';
  }
}

}  // namespace first_contact::program
