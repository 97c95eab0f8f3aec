// Looks like: the line is hit, and nobody asks whether that is on the edge: it has no ends.
// Ask: at your time, where along the edge is the ball? The edge goes from 0 to e.e in (S(t) - a).e.
// Seen in: PhysX (NVIDIAGameWorks/PhysX#597), the other way round: hits outside of the edge's cylinder were
// missed
#include "task.hpp"

std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector e = b - a, m = cross(e, S0 - a), v = cross(e, V);
  const double vv = dot(v, v), mv = dot(m, v), under = vv * dot(e, e) * r * r - dot(cross(m, v), cross(m, v));
  if (mv >= 0 || under < 0) return {};
  const double t = (-mv - std::sqrt(under)) / vv;
  if (t > 1) return {};
  return t;
}
