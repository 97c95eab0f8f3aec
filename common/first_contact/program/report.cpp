#include "first_contact/program/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace first_contact::program {

namespace {

std::string formatted(const char* form, double value) {
  char text[40];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

bool is_flat(const Json& json) {
  return std::none_of(json.begin(), json.end(), [](const Json& part) { return part.is_structured(); });
}

// An object stands with a member a line; a list of plain values on one line.
void write(std::string& out, const Json& json, const std::string& indent) {
  if (json.is_number_float()) {
    const auto value = json.get<double>();
    out += std::isfinite(value) ? formatted("%.17g", value) : "null";
  } else if (!json.is_structured() || json.empty()) {
    out += json.dump();
  } else {
    const bool on_one_line = json.is_array() && is_flat(json);
    const std::string inner = on_one_line ? "" : "\n" + indent + "  ";
    std::string separator = inner;
    out += json.is_array() ? '[' : '{';
    for (const auto& [key, value] : json.items()) {
      out += separator;
      separator = (on_one_line ? ", " : ",") + inner;
      if (json.is_object()) out += Json(key).dump() + ": ";
      write(out, value, indent + "  ");
    }
    if (!on_one_line) out += "\n" + indent;
    out += json.is_array() ? ']' : '}';
  }
}

}  // namespace

Json to_json(const Vector& value) { return Json::array({value.x(), value.y(), value.z()}); }

Json to_json(const ContactPoints& points) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < points.cols(); ++i) list.push_back(to_json(Vector(points.col(i))));
  return list;
}

std::string to_string(const Json& json) {
  std::string text;
  write(text, json, "");
  return text;
}

std::string readable(double value) { return formatted("%.6g", value == 0 ? 0.0 : value); }
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
