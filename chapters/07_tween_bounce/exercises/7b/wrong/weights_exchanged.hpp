// Looks like: t and 1 - t are exchanged: it begins at the last point.
// Ask: at t = 0, how much of a and how much of b is in your mixture?
#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  auto left = points;
  for (; left.size() > 1; left.pop_back())
    for (std::size_t i = 0; i + 1 < left.size(); ++i) left[i] = t * left[i] + (1 - t) * left[i + 1];
  return left[0];
}
