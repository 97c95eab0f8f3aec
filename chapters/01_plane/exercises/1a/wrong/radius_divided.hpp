// Looks like: r is divided by the length of N where it should be multiplied.
// Ask: E.S is |N| times the distance. For which E.S does the ball touch?
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const double t = (r / norm(E.N) - dot(E, S0)) / dot(E.N, V);
  if (!(t >= 0 && t <= 1)) return {};
  return t;
}
