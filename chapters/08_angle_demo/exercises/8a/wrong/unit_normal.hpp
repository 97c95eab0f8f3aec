// Looks like: N is taken to have length 1.
// Ask: with an N of length 5 they part 25 times too fast. By what must the impulse be divided?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N),
               j = -(1 + e) * s / (1 / first.mass + 1 / second.mass);
  if (s >= 0) return {first.velocity, second.velocity};
  return {first.velocity + j / first.mass * N, second.velocity - j / second.mass * N};
}
