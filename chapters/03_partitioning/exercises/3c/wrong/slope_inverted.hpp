// Looks like: the slope of the side is turned over: dy/dx instead of dx/dy.
// Ask: a side goes up by 1 while it goes right by 4. How far right is it when it has gone up by 1/2?
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2 a = polygon[i], b = polygon[j];
    if ((a.y > P.y) != (b.y > P.y) && P.x < a.x + (P.y - a.y) * (a.x == b.x ? 0 : (b.y - a.y) / (b.x - a.x)))
      in = !in;
  }
  return in;
}
