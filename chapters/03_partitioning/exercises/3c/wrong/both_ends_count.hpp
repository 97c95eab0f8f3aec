// Looks like: both ends of a side count, or neither does: where the way leads through a corner, it crosses
// twice or not at all.
// Ask: the way from the diamond's centre leaves it through a corner. How many times does it leave?
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2 a = polygon[i], b = polygon[j];
    if (a.y == b.y || P.y < std::min(a.y, b.y) || P.y > std::max(a.y, b.y)) continue;
    if (P.x < a.x + (P.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}
