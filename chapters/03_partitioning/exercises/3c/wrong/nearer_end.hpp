// Looks like: a side is crossed when one of its ends is to the right: where it is at the height of P was not
// asked.
// Ask: a slanted side begins left of P and ends right of it. On which side of P does it pass?
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    if ((polygon[i].y > P.y) != (polygon[j].y > P.y) && P.x < std::max(polygon[i].x, polygon[j].x)) in = !in;
  return in;
}
