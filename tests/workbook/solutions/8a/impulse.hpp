#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N);
  if (s >= 0) return {first.velocity, second.velocity};
  const double j = -(1 + e) * s / (dot(N, N) * (1 / first.mass + 1 / second.mass));
  return {first.velocity + j / first.mass * N, second.velocity - j / second.mass * N};
}
