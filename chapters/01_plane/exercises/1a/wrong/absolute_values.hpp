// Looks like: absolute values are taken, of the distance or of the motion: a ball that leaves is said to
// touch.
// Ask: which sign has N.V when the ball moves away? What becomes of it in your code?
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const double length = norm(E.N), t = (std::abs(dot(E, S0)) / length - r) / (std::abs(dot(E.N, V)) / length);
  if (!(t >= 0 && t <= 1)) return {};
  return t;
}
