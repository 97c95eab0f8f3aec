// Looks like: e stands where 1 + e should: with e = 1 they only come to rest against each other.
// Ask: how much of the impulse is needed to stop them, and how much to send them back?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N),
               j = -e * s / (dot(N, N) * (1 / first.mass + 1 / second.mass));
  if (s >= 0) return {first.velocity, second.velocity};
  return {first.velocity + j / first.mass * N, second.velocity - j / second.mass * N};
}
