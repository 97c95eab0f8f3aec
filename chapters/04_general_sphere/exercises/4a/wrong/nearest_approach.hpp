// Looks like: the time of the nearest approach: the point is deep inside by then.
// Ask: how far is the point from the origin at your time, and how far when it touches?
#include "task.hpp"

std::optional<double> first_root(Vector m, Vector v, double r) {
  const double a = dot(v, v), b = dot(m, v);
  const Vector c = cross(m, v);
  if (b >= 0 || a * r * r < dot(c, c)) return {};
  return -b / a;
}
