#include "first_contact/program/json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace first_contact::program {

namespace {

std::string seventeen_digits(double value) {
  if (!std::isfinite(value)) return "null";
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

bool is_flat(const Json& json) {
  return std::none_of(json.begin(), json.end(), [](const Json& part) { return part.is_structured(); });
}

// An object stands with a member a line; a list of plain values on one line.
void write(std::string& out, const Json& json, const std::string& indent) {
  if (json.is_number_float()) {
    out += seventeen_digits(json.get<double>());
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

std::string to_string(const Json& json) {
  std::string text;
  write(text, json, "");
  return text;
}

double finite(double value, const std::string& place) {
  if (std::isfinite(value)) return value;
  throw std::invalid_argument("must not lead beyond the range of numbers, as " + place + " does");
}

}  // namespace first_contact::program
