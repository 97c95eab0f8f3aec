// Looks like: one round is made: a point of the first side.
// Ask: how many points are left after one round?
#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  if (points.size() == 1) return points[0];
  return (1 - t) * points[0] + t * points[1];
}
