// Looks like: the ends are compared with where the ball starts, not with where it touches.
// Ask: the ball starts beside the edge and drifts along it. Where is it when it touches?
#include "task.hpp"

std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector e = b - a, m = cross(e, S0 - a), v = cross(e, V);
  const double vv = dot(v, v), mv = dot(m, v), under = vv * dot(e, e) * r * r - dot(cross(m, v), cross(m, v));
  if (mv >= 0 || under < 0 || dot(S0 - a, e) < 0 || dot(S0 - a, e) > dot(e, e)) return {};
  const double t = (-mv - std::sqrt(under)) / vv;
  if (t > 1) return {};
  return t;
}
