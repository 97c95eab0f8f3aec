#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const double length = norm(E.N), before = dot(E, S0) / length, after = dot(E, S0 + V) / length;
  if (after > r) return {};
  return (before - r) / (before - after);
}
