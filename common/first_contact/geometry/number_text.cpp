#include "first_contact/geometry/number_text.hpp"

#include <array>
#include <cstdio>

namespace first_contact {

// A stream would say the same, and bring all that it knows of money and months into the smallest program.
std::string to_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

}  // namespace first_contact
