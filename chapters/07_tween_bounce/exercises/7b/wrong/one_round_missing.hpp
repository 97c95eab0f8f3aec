// Looks like: it stops one round too early, with two points left, and gives the first of them.
// Ask: how many rounds do four points need until one is left?
#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  auto left = points;
  for (; left.size() > 2; left.pop_back())
    for (std::size_t i = 0; i + 1 < left.size(); ++i) left[i] = (1 - t) * left[i] + t * left[i + 1];
  return left[0];
}
