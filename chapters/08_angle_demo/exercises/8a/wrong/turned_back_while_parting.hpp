// Looks like: there is no test of approaching: two that part are turned back into each other.
// Ask: the two overlap a little and fly apart. Who turns them round?
// Seen in: Ten Minute Physics, handleBallCollision; Game Physics in One Weekend, ResolveContact;
// erincatto/box3d#32
#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const double s = dot(first.velocity - second.velocity, N),
               j = -(1 + e) * s / (dot(N, N) * (1 / first.mass + 1 / second.mass));
  return {first.velocity + j / first.mass * N, second.velocity - j / second.mass * N};
}
