#include "task.hpp"

static std::vector<Vector> lower_ends(Vector axis, Vector N) {
  const double slope = dot(axis, N), length = norm(axis);
  if (length == 0) return {{}};
  if (std::abs(slope) <= 16 * std::numeric_limits<double>::epsilon() * length)
    return {-0.5 * axis, 0.5 * axis};
  if (slope > 0) return {-0.5 * axis};
  return {0.5 * axis};
}

std::vector<Point> lowest_points(const Box& box, Vector N) {
  std::vector<Point> all;
  for (const Vector& r : lower_ends(box.R, N))
    for (const Vector& s : lower_ends(box.S, N))
      for (const Vector& t : lower_ends(box.T, N)) all.push_back(box.Q + r + s + t);
  return all;
}
