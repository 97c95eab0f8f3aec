#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  std::vector<Point> points{box.Q};
  for (const Vector& axis : {box.R, box.S, box.T}) {
    const double slope = dot(axis, N), level = 16 * std::numeric_limits<double>::epsilon() * norm(axis);
    if (norm(axis) == 0) continue;
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (std::abs(slope) <= level) points.push_back(points[i] + 0.5 * axis);
      points[i] = points[i] - (slope > level || std::abs(slope) <= level ? 0.5 : -0.5) * axis;
    }
  }
  return points;
}
