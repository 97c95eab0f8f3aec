// Looks like: all sides level with the point are counted, those to its left as well: the count is always
// even.
// Ask: a whole line crosses a closed curve how many times? And half a line?
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    if ((polygon[i].y > P.y) != (polygon[j].y > P.y)) in = !in;
  return in;
}
