// Looks like: two that move apart are said to have met: t is negative.
// Ask: which sign has w.u when they come nearer?
#include "task.hpp"

std::optional<float> meet(const Float3& w, const Float3& u, float d) {
  const float uu = dot(u, u), wu = dot(w, u);
  const Float3 c = cross(w, u);
  const float under = uu * d * d - dot(c, c);
  if (uu == 0 || under < 0) return {};
  const float t = (-wu - std::sqrt(under)) / uu;
  if (t > 1) return {};
  return t;
}
