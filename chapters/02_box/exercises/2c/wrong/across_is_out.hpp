// Looks like: a box across a plane is rejected: you ask whether it is not wholly inside.
// Ask: half of the box is in front of the plane. May it vanish from the picture?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum)
    if (dot(E, box.Q) <
        0.5 * (std::abs(dot(box.R, E.N)) + std::abs(dot(box.S, E.N)) + std::abs(dot(box.T, E.N))))
      return true;
  return false;
}
