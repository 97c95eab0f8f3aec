#include "workbook/value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace workbook {
namespace {

using Kind = Value::Kind;

std::string hexadecimal(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", number);
  return text;
}

std::string joined(const std::vector<Value>& parts, const char* between, std::string (*part)(const Value&)) {
  std::string text;
  for (const Value& each : parts) text += (text.empty() ? "" : between) + part(each);
  return text;
}

Value read_from(std::istream& words) {
  std::string word;
  if (!(words >> word)) throw std::invalid_argument("an answer ends too early");
  if (word == "-") return {};
  if (word == "(" || word == "[") {
    Value value{word == "(" ? Kind::group : Kind::list, 0, {}};
    while (words >> std::ws && words.peek() != ')' && words.peek() != ']')
      value.parts.push_back(read_from(words));
    words >> word;
    return value;
  }
  const Kind kind = word[0] == 't' ? Kind::truth : word[0] == 'i' ? Kind::whole : Kind::number;
  return {kind, std::strtod(word.c_str() + 1, nullptr), {}};
}

bool same_number(double a, double b, const Sameness& sameness) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  if (a == b || std::isinf(a) || std::isinf(b)) return a == b;
  return std::abs(a - b) <= sameness.tolerance * std::max({std::abs(a), std::abs(b), sameness.unit});
}

// Each part has a partner of its own, wherever it stands.
bool same_in_any_order(const Value& a, Value b, const Sameness& sameness) {
  for (const Value& part : a.parts) {
    const auto partner = std::find_if(b.parts.begin(), b.parts.end(),
                                      [&](const Value& other) { return same(part, other, sameness); });
    if (partner == b.parts.end()) return false;
    b.parts.erase(partner);
  }
  return true;
}

}  // namespace

std::string written(const Value& value) {
  switch (value.kind) {
    case Kind::nothing:
      return "-";
    case Kind::truth:
      return "t" + hexadecimal(value.number);
    case Kind::whole:
      return "i" + hexadecimal(value.number);
    case Kind::number:
      return "n" + hexadecimal(value.number);
    case Kind::group:
      return "( " + joined(value.parts, " ", written) + " )";
    case Kind::list:
      return "[ " + joined(value.parts, " ", written) + " ]";
  }
  return "-";
}

Value read_value(const std::string& line) {
  std::istringstream words(line);
  return read_from(words);
}

std::string shown(const Value& value) {
  switch (value.kind) {
    case Kind::nothing:
      return "nothing";
    case Kind::truth:
      return value.number != 0 ? "true" : "false";
    case Kind::group:
      return "(" + joined(value.parts, ", ", shown) + ")";
    case Kind::list:
      return "[" + joined(value.parts, ", ", shown) + "]";
    case Kind::whole:
    case Kind::number:
      break;
  }
  if (std::isnan(value.number)) return "not a number";
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value.number == 0 ? 0.0 : value.number).ptr;
  return {text, end};
}

Value rounded(const Value& value, double step) {
  Value result = value;
  const double unit = std::pow(10, std::ceil(-std::log10(step)));
  const double number = std::round(value.number * unit) / unit;
  if (value.kind == Value::Kind::number && std::isfinite(number)) result.number = number;
  for (Value& part : result.parts) part = rounded(part, step);
  return result;
}

std::vector<double> numbers_in(const Value& value) {
  if (value.kind == Kind::nothing) return {};
  if (value.kind != Kind::group && value.kind != Kind::list) return {value.number};
  std::vector<double> numbers;
  for (const Value& part : value.parts)
    for (const double number : numbers_in(part)) numbers.push_back(number);
  return numbers;
}

double largest_number(const Value& value) {
  double largest = 0;
  for (const double number : numbers_in(value)) largest = std::max(largest, std::abs(number));
  return largest;
}

bool has_nan(const Value& value) {
  const auto numbers = numbers_in(value);
  return std::any_of(numbers.begin(), numbers.end(), [](double number) { return std::isnan(number); });
}

bool same(const Value& a, const Value& b, const Sameness& sameness) {
  if (a.kind != b.kind || a.parts.size() != b.parts.size()) return false;
  const Sameness inside{sameness.tolerance, sameness.unit, false};
  if (a.kind == Kind::list && sameness.any_order) return same_in_any_order(a, b, inside);
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    if (!same(a.parts[i], b.parts[i], inside)) return false;
  return same_number(a.number, b.number, inside);
}

}  // namespace workbook
