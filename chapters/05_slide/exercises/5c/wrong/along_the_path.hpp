// Looks like: the gap is laid back along the path: at one degree only its sine, 1.7 %, is left between ball
// and wall.
// Ask: the ball comes in flat. After it has gone back by g, how far is it above the floor?
// Seen in: Fauerby's Improved Collision Detection and Response, p. 46; noonat/intersect
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V);
  if (toward >= 0) return 1;
  const double t = (r - dot(E, S0)) / toward;
  if (t > 1) return 1;
  return std::max(0.0, t - gap / norm(V));
}
