// Looks like: what is under the root is b^2 - ac with c = m.m - r^2, as at school. Far away two giants are
// subtracted, and r^2 is lost; to take c/(-b + root) in the end does not bring it back.
// Ask: m.m is 10^14 and r^2 is 1. How many digits of a double are left for r^2 after b^2 - a(m.m - r^2)?
// Seen in: noonat/intersect; Game Physics in One Weekend; the paper, 2.3
#include "task.hpp"

std::optional<double> first_root(Vector m, Vector v, double r) {
  const double a = dot(v, v), b = dot(m, v), c = dot(m, m) - r * r;
  if (b >= 0) return {};
  const double under = b * b - a * c;
  if (under < 0) return {};
  return (-b - std::sqrt(under)) / a;
}
