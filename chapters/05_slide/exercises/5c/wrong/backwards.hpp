// Looks like: a ball that is within the gap goes back: t is negative.
// Ask: who moves the ball away from the wall when nobody asked for it?
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V);
  if (toward >= 0) return 1;
  return std::min(1.0, (r + gap - dot(E, S0)) / toward);
}
