#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace first_contact::program {

/// A value that an option must not have; the message names the value and the rule.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which numbers an option may have.
enum class Range { finite, infinite_too };

/// A number as users type it, read strictly: all of the text, in C's notation, and in the range.
/// \throws Refused with the rule that is broken.
double number_of(const std::string& text, Range range = Range::finite);

/// So many numbers, separated by commas and nothing else.
/// \throws Refused with the rule that is broken.
std::vector<double> numbers_of(const std::string& text, std::size_t count, Range range = Range::finite);

}  // namespace first_contact::program
