// Looks like: the velocity is taken to have length 1: a = v.v is not divided by.
// Ask: with twice the velocity, is the time longer or shorter?
#include "task.hpp"

std::optional<double> first_root(Vector m, Vector v, double r) {
  const double b = dot(m, v), under = b * b - (dot(m, m) - r * r);
  if (b >= 0 || under < 0) return {};
  return -b - std::sqrt(under);
}
