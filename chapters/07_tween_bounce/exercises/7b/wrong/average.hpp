// Looks like: the mean of the points of the last round but one, or of all of them: t is not used to the end.
// Ask: at t = 0 the curve is at its first point. Where are you?
#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  Vector2 sum = 0 * t * points[0];
  for (const Vector2& each : points) sum = sum + each;
  return sum / static_cast<double>(points.size());
}
