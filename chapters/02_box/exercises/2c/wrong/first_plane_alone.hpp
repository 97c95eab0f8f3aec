// Looks like: the answer is given after the first plane: the loop returns too early.
// Ask: what does your function return when the first plane does not reject?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const Plane& E : frustum)
    return dot(E, box.Q) <
           -0.5 * (std::abs(dot(box.R, E.N)) + std::abs(dot(box.S, E.N)) + std::abs(dot(box.T, E.N)));
  return false;
}
