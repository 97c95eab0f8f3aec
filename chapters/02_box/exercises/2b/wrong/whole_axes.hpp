// Looks like: the ends of the axes are taken twice as far away: the axes are as long as the box, not half as
// long.
// Ask: how far is it from the centre of a box to the end of R?
#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  std::vector<Point> points{box.Q};
  for (const Vector& axis : {box.R, box.S, box.T}) {
    const double slope = dot(axis, N);
    if (norm(axis) == 0) continue;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      const bool level = std::abs(slope) <= 16 * std::numeric_limits<double>::epsilon() * norm(axis);
      const Point middle = points[i];
      points[i] = middle - (slope < 0 && !level ? -1 : 1) * axis;
      if (level) points.push_back(middle + axis);
    }
  }
  return points;
}
