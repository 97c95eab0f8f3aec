// Looks like: of a level axis the same end is listed twice when its product with N is -0, or is rounded to a
// trifle below 0.
// Ask: which end does the sign of a slope choose that is nothing but rounding? And which is the other one?
#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  std::vector<Point> points{box.Q};
  for (const Vector& axis : {box.R, box.S, box.T}) {
    const double slope = dot(axis, N), level = 16 * std::numeric_limits<double>::epsilon() * norm(axis);
    if (norm(axis) == 0) continue;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (std::abs(slope) <= level) points.push_back(points[i] + 0.5 * axis);
      points[i] = points[i] - std::copysign(0.5, slope) * axis;
    }
  }
  return points;
}
