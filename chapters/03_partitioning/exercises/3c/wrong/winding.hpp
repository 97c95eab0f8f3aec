// Looks like: the turns around the point are counted, and any number but 0 is called inside: where the
// outline crosses itself, two turns are two.
// Ask: a pentagram is drawn in one line. Is its middle inside, if an even number of sides is crossed on the
// way out?
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  int turns = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2 a = polygon[j], b = polygon[i];
    if (a.y <= P.y && b.y > P.y && cross(b - a, P - a) > 0) ++turns;
    if (a.y > P.y && b.y <= P.y && cross(b - a, P - a) < 0) --turns;
  }
  return turns != 0;
}
