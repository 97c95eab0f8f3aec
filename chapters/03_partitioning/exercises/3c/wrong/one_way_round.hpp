// Looks like: inside means left of all sides: that holds for convex polygons whose corners go round against
// the clock.
// Ask: turn the list of corners round. Is it another polygon?
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    if (cross(polygon[i] - polygon[j], P - polygon[j]) <= 0) return false;
  return true;
}
