// Looks like: the side is taken from the motion, not from where the ball is: whatever moves against N is in
// front.
// Ask: a ball behind the plane moves on, away from it, against N. Which side is it on?
#include "task.hpp"

std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) {
  const double side = dot(E.N, V) > 0 ? -1 : 1, height = side * dot(E, S0), toward = side * dot(E.N, V);
  if (toward == 0) return {};
  if (height <= r) return 0;
  const double t = (r - height) / toward;
  if (t > 1) return {};
  return t;
}
