#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  if (points.size() == 1) return points[0];
  std::vector<Vector2> fewer;
  for (std::size_t i = 1; i < points.size(); ++i)
    fewer.push_back(points[i - 1] + t * (points[i] - points[i - 1]));
  return bezier(fewer, t);
}
