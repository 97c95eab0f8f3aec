// Looks like: what is under the root is as printed, and where it comes out negative you take 0: no hit is
// lost, but misses become hits, and the place is wrong.
// Ask: what does rounding make of a path that passes by at 2 d?
#include "task.hpp"

std::optional<float> meet(const Float3& w, const Float3& u, float d) {
  const float uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (wu >= 0) return {};
  const float t = (-wu - std::sqrt(std::max(0.0f, under))) / uu;
  if (t > 1) return {};
  return t;
}
