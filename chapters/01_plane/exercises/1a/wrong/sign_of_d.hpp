// Looks like: a plane N.Q = D; here it is N.Q + D = 0.
// Ask: where is the floor with N = (0, 0, 1) and D = -3, and what is E.S for a point on it? It is right for D
// = 0 alone.
// Seen in: three.js (mrdoob/three.js#11818)
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const double length = norm(E.N);
  const double t = (r - (dot(E.N, S0) - E.D) / length) / (dot(E.N, V) / length);
  if (!(t >= 0 && t <= 1)) return {};
  return t;
}
