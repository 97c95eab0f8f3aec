// Looks like: the inverse of the one easing, the cube root, is used for all of them.
// Ask: what is the inverse of 1 - (1 - s)^3?
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  if (to > r) return {};
  return std::cbrt((from - r) / (from - to)) + 0 * ease(easing, 0);
}
