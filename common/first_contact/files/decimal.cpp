#include "first_contact/files/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <locale>
#include <sstream>
#include <version>

namespace first_contact {
namespace {

constexpr std::string_view digits = "0123456789";

// Moves the text behind its first digits; how many they were.
std::size_t pass_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of(digits), text.size());
  text.remove_prefix(count);
  return count;
}

bool pass(std::string_view& text, std::string_view any_of) {
  const bool found = !text.empty() && any_of.find(text[0]) != std::string_view::npos;
  if (found) text.remove_prefix(1);
  return found;
}

// "12", "12.", ".5", "1.5e-3", without a sign.
bool is_number(std::string_view text) {
  std::size_t count = pass_digits(text);
  if (pass(text, ".")) count += pass_digits(text);
  if (count == 0) return false;
  if (pass(text, "eE")) {
    pass(text, "+-");
    if (pass_digits(text) == 0) return false;
  }
  return text.empty();
}

bool is_word(std::string_view text, std::string_view word) {
  return text.size() == word.size() &&
         std::equal(text.begin(), text.end(), word.begin(), [](char a, char b) { return (a | 0x20) == b; });
}

// The stream's own way, which keeps its value beside a failure: 0 or a small number below the range, a large
// one above.
double by_stream(std::string_view text) {
  std::istringstream in{std::string(text)};
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  return in.fail() && value > 1 ? std::numeric_limits<double>::infinity() : value;
}

// std::from_chars tells what is beyond the range, but not on which side; and some libraries have it for
// integers only.
double magnitude(std::string_view text) {
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  double value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc{}) return value;
#endif
  return by_stream(text);
}

}  // namespace

std::optional<double> decimal(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const double sign = negative ? -1 : 1;
  if (is_word(text, "inf") || is_word(text, "infinity"))
    return sign * std::numeric_limits<double>::infinity();
  if (is_word(text, "nan")) return std::numeric_limits<double>::quiet_NaN();
  if (!is_number(text)) return std::nullopt;
  return sign * magnitude(text);
}

std::string shortest(double value) {
  std::array<char, 32> text{};
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
#else
  for (int count = 1; count <= std::numeric_limits<double>::max_digits10; ++count) {
    std::snprintf(text.data(), text.size(), "%.*g", count, value);
    if (decimal(text.data()) == value) break;
  }
  return text.data();
#endif
}

}  // namespace first_contact
