// Looks like: a point that moves away is said to have entered: t is negative.
// Ask: m.v is positive. Was the sphere entered before 0 or after?
#include "task.hpp"

std::optional<double> first_root(Vector m, Vector v, double r) {
  const double a = dot(v, v), b = dot(m, v);
  const Vector c = cross(m, v);
  const double under = a * r * r - dot(c, c);
  if (a == 0 || under < 0) return {};
  return (-b - std::sqrt(under)) / a;
}
