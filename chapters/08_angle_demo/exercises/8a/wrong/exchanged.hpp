// Looks like: the velocities along the normal are exchanged: right for equal masses and e = 1 alone.
// Ask: a lorry meets a bicycle. Do they exchange their velocities?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N);
  if (s >= 0) return {first.velocity, second.velocity};
  return {first.velocity - s / dot(N, N) * N, second.velocity + s / dot(N, N) * N + 0 * e * N};
}
