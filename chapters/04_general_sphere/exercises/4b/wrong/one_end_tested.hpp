// Looks like: the edge begins at a and goes on beyond b.
// Ask: (S(t) - a).e is at least 0. How large may it be at most?
#include "task.hpp"

std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector e = b - a, m = cross(e, S0 - a), v = cross(e, V);
  const double vv = dot(v, v), mv = dot(m, v), under = vv * dot(e, e) * r * r - dot(cross(m, v), cross(m, v));
  if (mv >= 0 || under < 0) return {};
  const double t = (-mv - std::sqrt(under)) / vv;
  if (t > 1 || dot(S0 + t * V - a, e) < 0) return {};
  return t;
}
