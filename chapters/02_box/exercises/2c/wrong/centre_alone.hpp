// Looks like: only the centre is looked at: a box is rejected although a part of it is in view.
// Ask: the centre of a long plank is outside. Is all of the plank?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum)
    if (dot(E, box.Q) < 0) return true;
  return false;
}
