// Looks like: the least distance is found as w^2 - (w.u)^2/u^2: the same two giants, in other clothes.
// Ask: which of your differences is of two numbers that are 10^8 times as large as what is left?
#include "task.hpp"

std::optional<float> meet(const Float3& w, const Float3& u, float d) {
  const float uu = dot(u, u), wu = dot(w, u);
  if (wu >= 0) return {};
  const float near2 = dot(w, w) - wu * wu / uu;
  if (near2 > d * d) return {};
  const float t = -wu / uu - std::sqrt((d * d - near2) / uu);
  if (t > 1) return {};
  return t;
}
