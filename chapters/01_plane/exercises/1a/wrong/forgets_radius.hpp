// Looks like: the time at which the centre meets the plane, and not the ball.
// Ask: how high is the centre above the floor when the ball touches it?
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double) {
  const double t = -dot(E, S0) / dot(E.N, V);
  if (!(t >= 0 && t <= 1)) return {};
  return t;
}
