// Looks like: an axis is level only if its product with N is exactly 0: turned together with its floor, the
// box stands on one corner.
// Ask: cos and sin are rounded. What is left of a product that should be 0?
// Seen in: the paper, 1.3, after Lengyel's rule
#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  std::vector<Point> points{box.Q};
  for (const Vector& axis : {box.R, box.S, box.T}) {
    const double slope = dot(axis, N);
    if (norm(axis) == 0) continue;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const bool level = slope == 0;
      const Point middle = points[i];
      points[i] = middle - (slope < 0 && !level ? -0.5 : 0.5) * axis;
      if (level) points.push_back(middle + 0.5 * axis);
    }
  }
  return points;
}
