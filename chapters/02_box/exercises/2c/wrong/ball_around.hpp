// Looks like: the ball around the box is tested instead of the box: it rejects too little.
// Ask: a long plank stands upright behind the near plane. How far does it reach toward it?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  const double radius = 0.5 * std::sqrt(dot(box.R, box.R) + dot(box.S, box.S) + dot(box.T, box.T));
  for (const Plane& E : frustum)
    if (dot(E, box.Q) < -radius) return true;
  return false;
}
