// Looks like: it is not asked whether the ball comes nearer: one that overlaps and leaves is told when it is
// out.
// Ask: at your time the ball touches the plane from which side of its motion, coming or going?
#include "task.hpp"

std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) {
  const double side = dot(E, S0) < 0 ? -1 : 1, height = side * dot(E, S0), toward = side * dot(E.N, V);
  if (toward == 0) return {};
  const double t = (r - height) / toward;
  if (toward > 0 && t < 0) return {};
  if (t > 1) return {};
  return std::max(0.0, t);
}
