// Looks like: e is not used: all bodies are of steel.
// Ask: where does e stand in your code?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N),
               j = -2 * s / (dot(N, N) * (1 / first.mass + 1 / second.mass));
  if (s >= 0) return {first.velocity, second.velocity};
  return {first.velocity + j / first.mass * N, second.velocity - j / second.mass * N + 0 * e * N};
}
