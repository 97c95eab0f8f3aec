// Looks like: a contact after the end of the motion counts.
// Ask: the motion ends half way. Have they met?
#include "task.hpp"

std::optional<float> meet(const Float3& w, const Float3& u, float d) {
  const float uu = dot(u, u), wu = dot(w, u);
  const Float3 c = cross(w, u);
  const float under = uu * d * d - dot(c, c);
  if (wu >= 0 || under < 0) return {};
  return (-wu - std::sqrt(under)) / uu;
}
