// Looks like: inside means left of all sides, or right of all of them: that holds for convex polygons alone.
// Ask: in the left arm of a bay, on which side of the right arm's inner border are you?
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  bool left = true, right = true;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const double side = cross(polygon[i] - polygon[j], P - polygon[j]);
    left = left && side > 0, right = right && side < 0;
  }
  return left || right;
}
