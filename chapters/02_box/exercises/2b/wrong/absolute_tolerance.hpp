// Looks like: the tolerance does not grow with the box: what is a length is compared with a number that has
// no unit.
// Ask: measure the same box in millimetres instead of metres. Is it still flat?
#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  std::vector<Point> points{box.Q};
  for (const Vector& axis : {box.R, box.S, box.T}) {
    const double slope = dot(axis, N);
    if (norm(axis) == 0) continue;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const bool level = std::abs(slope) <= 1e-15;
      const Point middle = points[i];
      points[i] = middle - (slope < 0 && !level ? -0.5 : 0.5) * axis;
      if (level) points.push_back(middle + 0.5 * axis);
    }
  }
  return points;
}
