// Looks like: the plane is moved by r, but away from the ball: D + r.
// Ask: E' is where the centre is when the ball touches. Is that in front of the plane, or behind it?
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const double length = norm(E.N);
  const double t = -(dot(E, S0) / length + r) / (dot(E.N, V) / length);
  if (!(t >= 0 && t <= 1)) return {};
  return t;
}
