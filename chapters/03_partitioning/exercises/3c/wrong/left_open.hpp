// Looks like: the side from the last corner back to the first is left out.
// Ask: how many sides has a polygon of four corners, and how many does your loop visit?
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  bool in = false;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const Vector2 a = polygon[i], b = polygon[i - 1];
    if ((a.y > P.y) != (b.y > P.y) && P.x < a.x + (P.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}
