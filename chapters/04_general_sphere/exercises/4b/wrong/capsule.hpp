// Looks like: the ends are hit as well, as vertices: a sausage instead of a cylinder.
// Ask: beyond the end, which feature does the ball touch? Who will ask for that?
#include "task.hpp"

static std::optional<double> enter(Vector m, Vector v, double r) {
  const double vv = dot(v, v), mv = dot(m, v), under = vv * r * r - dot(cross(m, v), cross(m, v));
  if (mv >= 0 || under < 0) return {};
  return (-mv - std::sqrt(under)) / vv;
}

std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector e = b - a;
  auto t = enter(cross(e, S0 - a), cross(e, V), norm(e) * r);
  if (t && (dot(S0 + *t * V - a, e) < 0 || dot(S0 + *t * V - b, e) > 0)) t = {};
  for (const auto& end : {enter(S0 - a, V, r), enter(S0 - b, V, r)})
    if (end && (!t || *end < *t)) t = end;
  if (!t || *t > 1) return {};
  return t;
}
