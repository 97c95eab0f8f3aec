// Looks like: a touch that comes after the end of the motion counts.
// Ask: the ball starts at height 2 and sinks by 1; its radius is 1/2. Has it touched the floor when the
// motion ends?
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const double toward = dot(E.N, V);
  if (toward >= 0) return {};
  return (r * norm(E.N) - dot(E, S0)) / toward;
}
