#include "first_contact/program/numbers.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/files/decimal.hpp"

namespace first_contact::program {

double number_of(const std::string& text, Range range) {
  const bool plus = text.starts_with('+') && !text.starts_with("+-");
  const auto value = decimal(std::string_view(text).substr(plus ? 1 : 0));
  if (!value) throw Refused("must be a number");
  if (range == Range::finite && !std::isfinite(*value)) throw Refused("must be finite");
  if (std::isnan(*value)) throw Refused("must be a number");
  return *value;
}

std::vector<double> numbers_of(const std::string& text, std::size_t count, Range range) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    try {
      numbers.push_back(number_of(text.substr(begin, end - begin), range));
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
