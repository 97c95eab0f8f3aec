#include "task.hpp"

Velocities impact(const Body& first, const Body& second, Vector2 N, double e) {
  const Vector2 n = N / norm(N), t{-n.y, n.x};
  const double m1 = first.mass, m2 = second.mass, v1 = dot(first.velocity, n), v2 = dot(second.velocity, n);
  if (v1 >= v2) return {first.velocity, second.velocity};
  const double w1 = (m1 * v1 + m2 * v2 + m2 * e * (v2 - v1)) / (m1 + m2),
               w2 = (m1 * v1 + m2 * v2 + m1 * e * (v1 - v2)) / (m1 + m2);
  return {w1 * n + dot(first.velocity, t) * t, w2 * n + dot(second.velocity, t) * t};
}
