// Looks like: what is under the root may be negative, and you go on: a point that passes by is said to enter.
// Ask: how near does the path come to the origin when a r^2 - |m x v|^2 is negative?
#include "task.hpp"

std::optional<double> first_root(Vector m, Vector v, double r) {
  const double a = dot(v, v), b = dot(m, v);
  const Vector c = cross(m, v);
  if (b >= 0) return {};
  return (-b - std::sqrt(std::max(0.0, a * r * r - dot(c, c)))) / a;
}
