// Looks like: 2b and b are mixed: the formula of school with 4ac has 2 m.v for its b, and 2a below.
// Ask: write |m + tv|^2 out. What stands before t?
#include "task.hpp"

std::optional<double> first_root(Vector m, Vector v, double r) {
  const double a = dot(v, v), b = 2 * dot(m, v), c = dot(m, m) - r * r;
  if (b >= 0) return {};
  const double under = b * b - 4 * a * c;
  if (under < 0) return {};
  return (-b - std::sqrt(under)) / a;
}
