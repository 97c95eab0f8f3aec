// Looks like: D is left out, N.Q stands for E.Q: all six planes go through the origin.
// Ask: the near plane is at z = 1. Where does your test take it to be?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  return std::any_of(frustum.begin(), frustum.end(), [&](const Plane& E) {
    return dot(E.N, box.Q) <
           -0.5 * (std::abs(dot(box.R, E.N)) + std::abs(dot(box.S, E.N)) + std::abs(dot(box.T, E.N)));
  });
}
