// Looks like: the gap is laid back along the path, and only where the wall is met within the motion plus the
// gap.
// Ask: the ball comes in flat. After it has gone back by g, how far is it above the floor?
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V);
  if (toward >= 0) return 1;
  return std::clamp((r - dot(E, S0)) / toward - gap / norm(V), 0.0, 1.0);
}
