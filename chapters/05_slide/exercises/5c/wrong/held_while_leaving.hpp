// Looks like: a ball within the gap does not move at all, not even away from the wall or along it.
// Ask: it lies within the gap and wishes to jump. What holds it?
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double height = dot(E, S0) - r - gap, toward = dot(E.N, V);
  if (height <= 0) return 0;
  if (toward >= 0) return 1;
  return std::clamp(-height / toward, 0.0, 1.0);
}
