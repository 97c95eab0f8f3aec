// Looks like: what leads away from the wall is said to stop at once: 0 instead of 1.
// Ask: nothing is in the way. How much of its motion may the ball make?
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V);
  if (toward >= 0) return 0;
  return std::clamp((r + gap - dot(E, S0)) / toward, 0.0, 1.0);
}
