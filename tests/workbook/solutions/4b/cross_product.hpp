#include "task.hpp"

std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector e = b - a, m = cross(e, S0 - a), v = cross(e, V);
  const double vv = dot(v, v), mv = dot(m, v), under = vv * dot(e, e) * r * r - dot(cross(m, v), cross(m, v));
  if (mv >= 0 || under < 0) return {};
  const double t = (-mv - std::sqrt(under)) / vv, along = dot(S0 + t * V - a, e);
  if (t > 1 || along < 0 || along > dot(e, e)) return {};
  return t;
}
