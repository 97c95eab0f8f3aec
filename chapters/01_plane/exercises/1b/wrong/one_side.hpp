// Looks like: the ball is always in front of the plane.
// Ask: E.S0 = -2. What does a touch mean for this ball, r in front of the plane or r behind it?
#include "task.hpp"

std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) {
  const double height = dot(E, S0), toward = dot(E.N, V);
  if (toward >= 0) return {};
  if (height <= r) return 0;
  const double t = (r - height) / toward;
  if (t > 1) return {};
  return t;
}
