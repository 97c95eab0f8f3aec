// Looks like: only the first body changes: the second is a wall.
// Ask: is the momentum of both together what it was?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N),
               j = -(1 + e) * s / (dot(N, N) * (1 / first.mass + 1 / second.mass));
  if (s >= 0) return {first.velocity, second.velocity};
  return {first.velocity + j / first.mass * N, second.velocity};
}
