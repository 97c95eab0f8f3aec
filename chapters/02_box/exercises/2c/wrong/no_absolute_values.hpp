// Looks like: the effective radius is added without absolute values: it depends on which way the axes point.
// Ask: turn all three axes round. Is it not the same box?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum)
    if (dot(E, box.Q) < -0.5 * (dot(box.R, E.N) + dot(box.S, E.N) + dot(box.T, E.N))) return true;
  return false;
}
