#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  int crossed = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Vector2 low = polygon[i], high = polygon[(i + 1) % polygon.size()];
    if (low.y > high.y) std::swap(low, high);
    if (low.y <= P.y && P.y < high.y && cross(high - low, P - low) > 0) ++crossed;
  }
  return crossed % 2 == 1;
}
