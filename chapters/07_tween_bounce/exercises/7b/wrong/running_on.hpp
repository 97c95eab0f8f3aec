// Looks like: each new point is mixed with the one that was made just before, not with its old neighbour: the
// list is overwritten while it is read.
// Ask: from right to left or from left to right: which old points are still there when you need them?
#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  auto left = points;
  for (std::size_t round = 1; round < points.size(); ++round)
    for (std::size_t i = round; i < points.size(); ++i) left[i] = (1 - t) * left[i - 1] + t * left[i];
  return left.back();
}
