// Looks like: from each point one goes t of the way to the next, again and again: ((a to b) to c) to d.
// Ask: after the first mixture of a and b, with what must it be mixed?
#include "task.hpp"

Vector2 bezier(const std::vector<Vector2>& points, double t) {
  Vector2 at = points[0];
  for (const Vector2& next : points) at = (1 - t) * at + t * next;
  return at;
}
