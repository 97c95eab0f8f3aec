// Looks like: the slope of an axis is taken for its sign: the point is somewhere along the axis, not at its
// end.
// Ask: the box is Q + aR + bS + cT. Which two values of a are its ends, and which do you take?
#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  std::vector<Point> points{box.Q};
  for (const Vector& axis : {box.R, box.S, box.T}) {
    const double slope = dot(axis, N);
    if (norm(axis) == 0) continue;
    const bool level = std::abs(slope) <= 16 * std::numeric_limits<double>::epsilon() * norm(axis);
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (level) points.push_back(points[i] + 0.5 * axis);
      points[i] = points[i] - 0.5 * (level ? 1 : slope) * axis;
    }
  }
  return points;
}
