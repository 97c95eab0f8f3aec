#pragma once
#include <cstdio>
#include <string>

namespace tween_bounce {

/// A number with so many digits, as the paper prints its own.
inline std::string with_digits(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

}  // namespace tween_bounce
