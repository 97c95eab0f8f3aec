// Looks like: N is made a unit vector, and D stays as it was.
// Ask: [0, 0, 2, -6] and [0, 0, 1, -3] are the same plane. What becomes of D when N is divided by 2?
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const Vector N = E.N / norm(E.N);
  const double t = (r - dot(N, S0) - E.D) / dot(N, V);
  if (!(t >= 0 && t <= 1)) return {};
  return t;
}
