// Looks like: the time of the closest approach itself: half of the chord is not taken off.
// Ask: how far apart are the two at your time?
#include "task.hpp"

std::optional<float> meet(const Float3& w, const Float3& u, float d) {
  const float uu = dot(u, u), wu = dot(w, u);
  const Float3 c = cross(w, u);
  if (wu >= 0 || dot(c, c) > uu * d * d) return {};
  const float t = -wu / uu;
  if (t > 1) return {};
  return t;
}
