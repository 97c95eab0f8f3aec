#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2 a = polygon[i], b = polygon[j];
    if ((a.y > P.y) != (b.y > P.y) && P.x < a.x + (P.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}
