// Looks like: what comes from behind touches at +r: the sign of the side is used for the motion, and not for
// r.
// Ask: the ball rises to a ceiling at height 0. Does its centre come to height 1/2 or to -1/2?
#include "task.hpp"

std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) {
  const double height = dot(E, S0), toward = dot(E.N, V);
  if (std::abs(height) <= r) {
    if (height * toward < 0) return 0;
    return {};
  }
  if (height * toward >= 0) return {};
  const double t = (r - height) / toward;
  if (t > 1) return {};
  return t;
}
