// Looks like: each velocity is reflected at the normal for itself, as at a wall that does not move.
// Ask: a ball at rest is struck. What is there to be reflected?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double nn = dot(N, N);
  if (dot(first.velocity - second.velocity, N) >= 0) return {first.velocity, second.velocity};
  return {first.velocity - (1 + e) * dot(first.velocity, N) / nn * N,
          second.velocity - (1 + e) * dot(second.velocity, N) / nn * N};
}
