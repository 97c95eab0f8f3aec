// Looks like: restitution acts on the whole velocity, also across the normal: of 1 across, one half is left.
// Ask: the bodies are smooth. What can change the motion across the normal?
// Seen in: the paper, program 4, equation (2.4.2.6)
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const Vector2 u = first.velocity - second.velocity;
  const double s = dot(u, N), j = -2 * s / (dot(N, N) * (1 / first.mass + 1 / second.mass));
  if (s >= 0) return {first.velocity, second.velocity};
  const Vector2 common =
      (first.mass * first.velocity + second.mass * second.velocity) / (first.mass + second.mass);
  const Vector2 a = first.velocity + j / first.mass * N, b = second.velocity - j / second.mass * N;
  return {common + e * (a - common), common + e * (b - common)};
}
