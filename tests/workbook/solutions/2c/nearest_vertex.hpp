#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum) {
    Point highest = box.Q;
    for (const Vector& axis : {box.R, box.S, box.T})
      highest = highest + (dot(axis, E.N) < 0 ? -0.5 : 0.5) * axis;
    if (dot(E, highest) < 0) return true;
  }
  return false;
}
