#include "task.hpp"

std::optional<double> first_root(Vector m, Vector v, double r) {
  if (dot(m, v) >= 0) return {};
  const double speed = norm(v), way = -dot(m, v) / speed;
  const Vector nearest = cross(cross(v / speed, m), v / speed);
  const double half = r * r - dot(nearest, nearest);
  if (half < 0) return {};
  return (way - std::sqrt(half)) / speed;
}
