#include "task.hpp"

static double effective_radius(const Box& box, Vector N) {
  return 0.5 * (std::abs(dot(box.R, N)) + std::abs(dot(box.S, N)) + std::abs(dot(box.T, N)));
}

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  return std::any_of(frustum.begin(), frustum.end(),
                     [&](const Plane& E) { return dot(E, box.Q) + effective_radius(box, E.N) < 0; });
}
