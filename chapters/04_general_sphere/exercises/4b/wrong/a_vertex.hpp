// Looks like: the ball touches the end a, and not the edge: a sphere about a instead of a cylinder about the
// line.
// Ask: the ball comes down on the middle of the edge. How far is its centre from a when it touches?
#include "task.hpp"

std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector m = S0 - a, v = V;
  const double vv = dot(v, v), mv = dot(m, v), under = vv * r * r - dot(cross(m, v), cross(m, v));
  if (mv >= 0 || under < 0) return {};
  const double t = (-mv - std::sqrt(under)) / vv;
  if (t > 1 || norm(b - a) == 0) return {};
  return t;
}
