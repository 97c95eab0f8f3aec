// Looks like: the radius is twice too large: the axes are not halved. It rejects too little.
// Ask: how far is it from the centre of the box to the end of R?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum)
    if (dot(E, box.Q) < -(std::abs(dot(box.R, E.N)) + std::abs(dot(box.S, E.N)) + std::abs(dot(box.T, E.N))))
      return true;
  return false;
}
