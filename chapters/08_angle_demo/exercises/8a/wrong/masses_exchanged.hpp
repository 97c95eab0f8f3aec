// Looks like: each body takes the other's mass: the heavy one is thrown far, the light one hardly.
// Ask: an impulse changes a velocity by itself over which mass?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N),
               j = -(1 + e) * s / (dot(N, N) * (1 / first.mass + 1 / second.mass));
  if (s >= 0) return {first.velocity, second.velocity};
  return {first.velocity + j / second.mass * N, second.velocity - j / first.mass * N};
}
