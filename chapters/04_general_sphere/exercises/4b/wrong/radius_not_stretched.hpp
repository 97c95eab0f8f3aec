// Looks like: the vectors have become |e| times as long by the cross product with e, and the radius has not.
// Ask: what is |e x m| for a point at the distance 1 from an edge of length 2?
#include "task.hpp"

std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector e = b - a, m = cross(e, S0 - a), v = cross(e, V);
  const double vv = dot(v, v), mv = dot(m, v), under = vv * r * r - dot(cross(m, v), cross(m, v));
  if (mv >= 0 || under < 0) return {};
  const double t = (-mv - std::sqrt(under)) / vv, along = dot(S0 + t * V - a, e);
  if (t > 1 || along < 0 || along > dot(e, e)) return {};
  return t;
}
