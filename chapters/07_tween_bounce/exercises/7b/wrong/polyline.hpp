// Looks like: the point at t along the straight pieces from control point to control point: it goes through
// all of them.
// Ask: does a Bézier curve go through the points in its middle?
#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  if (points.size() == 1) return points[0];
  const double at = t * static_cast<double>(points.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), points.size() - 2);
  const double rest = at - static_cast<double>(i);
  return (1 - rest) * points[i] + rest * points[i + 1];
}
