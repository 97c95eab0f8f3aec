// Looks like: the contact of a ball that overlaps lies before the motion: t is negative.
// Ask: what will a program do that moves the ball to S0 + tV with this t?
#include "task.hpp"

std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) {
  const double side = dot(E, S0) < 0 ? -1 : 1, height = side * dot(E, S0), toward = side * dot(E.N, V);
  if (toward >= 0) return {};
  const double t = (r - height) / toward;
  if (t > 1) return {};
  return t;
}
