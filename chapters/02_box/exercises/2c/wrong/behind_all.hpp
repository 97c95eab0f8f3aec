// Looks like: only what is behind all six planes at once is rejected, and nothing is.
// Ask: can a box be behind the near plane and behind the far plane?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum)
    if (dot(E, box.Q) >=
        -0.5 * (std::abs(dot(box.R, E.N)) + std::abs(dot(box.S, E.N)) + std::abs(dot(box.T, E.N))))
      return false;
  return true;
}
