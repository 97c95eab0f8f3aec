#include "first_contact/program/numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace first_contact::program {

double number_of(const std::string& text) {
  double value = 0;
  const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last) throw Refused("must be a number");
  if (!std::isfinite(value)) throw Refused("must be finite");
  return value;
}

std::vector<double> numbers_of(const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    try {
      numbers.push_back(number_of(text.substr(begin, end - begin)));
    } catch (const Refused& error) {
      throw Refused("each part " + std::string(error.what()));
    }
    begin = end + 1;
  }
  if (numbers.size() != count)
    throw Refused("must be " + std::to_string(count) + " numbers, separated by commas and nothing else");
  return numbers;
}

}  // namespace first_contact::program
