// Looks like: the time at which the line meets the plane, also when that is before the motion begins or after
// it ends.
// Ask: what does t = 3 mean for a motion that lasts from 0 to 1? The paper asks no more than N.V other than
// 0; see
// "Any motion a collision" in chapter 1.
// Seen in: the paper, 1.2
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  if (dot(E.N, V) == 0) return {};
  return (r * norm(E.N) - dot(E, S0)) / dot(E.N, V);
}
