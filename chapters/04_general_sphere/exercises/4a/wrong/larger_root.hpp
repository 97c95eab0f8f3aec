// Looks like: this is the larger root: the time at which the point leaves the sphere.
// Ask: there are two. Which one comes first?
#include "task.hpp"

std::optional<double> first_root(Vector m, Vector v, double r) {
  const double a = dot(v, v), b = dot(m, v);
  const Vector c = cross(m, v);
  const double under = a * r * r - dot(c, c);
  if (b >= 0 || under < 0) return {};
  return (-b + std::sqrt(under)) / a;
}
