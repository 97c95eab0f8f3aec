// Looks like: the box around the polygon is tested, not the polygon.
// Ask: is the corner of a diamond's box inside of the diamond?
// Seen in: ActionScript's hitTestObject, by its own documents
#include "task.hpp"

bool inside(const std::vector<Vector2>& polygon, Vector2 P) {
  Vector2 least = polygon[0], most = polygon[0];
  for (const Vector2& each : polygon) {
    least = {std::min(least.x, each.x), std::min(least.y, each.y)};
    most = {std::max(most.x, each.x), std::max(most.y, each.y)};
  }
  return P.x > least.x && P.x < most.x && P.y > least.y && P.y < most.y;
}
