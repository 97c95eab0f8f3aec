// Looks like: the planes are taken to face outwards: what is far inside is rejected.
// Ask: E.Q is positive. Is Q in view, as far as this plane is concerned?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum)
    if (dot(E, box.Q) >
        0.5 * (std::abs(dot(box.R, E.N)) + std::abs(dot(box.S, E.N)) + std::abs(dot(box.T, E.N))))
      return true;
  return false;
}
