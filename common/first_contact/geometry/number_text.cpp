#include "first_contact/geometry/number_text.hpp"

#include <array>
#include <charconv>
#include <cstdio>

namespace first_contact {

// A stream would say the same, and bring all that it knows of money and months into the smallest program.
// printf has the mark of the host's locale; it serves where the standard library cannot do without it.
std::string to_text(double value) {
  std::array<char, 32> text{};
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  const auto form = std::chars_format::general;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, form, 6).ptr};
#else
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
#endif
}

}  // namespace first_contact
