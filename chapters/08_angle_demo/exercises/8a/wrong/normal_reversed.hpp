// Looks like: the impulse has the wrong sign: the bodies are pushed into each other, and fly on faster than
// they came. Momentum is kept, energy is not.
// Ask: N leads to the first body. Which way must the first body be pushed?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N),
               j = -(1 + e) * s / (dot(N, N) * (1 / first.mass + 1 / second.mass));
  if (s >= 0) return {first.velocity, second.velocity};
  return {first.velocity - j / first.mass * N, second.velocity + j / second.mass * N};
}
