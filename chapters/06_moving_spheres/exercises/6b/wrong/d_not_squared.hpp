// Looks like: d is compared with a square: |w x u|^2 with u^2 d.
// Ask: all lengths in millimetres instead of metres: does the comparison stay?
#include "task.hpp"

std::optional<float> meet(const Float3& w, const Float3& u, float d) {
  const float uu = dot(u, u), wu = dot(w, u);
  const Float3 c = cross(w, u);
  const float under = uu * d - dot(c, c);
  if (wu >= 0 || under < 0) return {};
  const float t = (-wu - std::sqrt(under)) / uu;
  if (t > 1) return {};
  return t;
}
