// Looks like: what is under the root is (w.u)^2 - u^2 (w^2 - d^2), as printed: far away d^2 is lost between
// two giants, and with it the hit.
// Ask: ten thousand d away w^2 is 10^8 d^2, and a float has 24 bits, seven digits. What is 10^8 - 1?
// And 10^4 - 1, a hundred d away: how many digits of the 1 are left?
// Seen in: the paper, 2.3; noonat/intersect; Game Physics in One Weekend
#include "task.hpp"

std::optional<float> meet(const Float3& w, const Float3& u, float d) {
  const float uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (wu >= 0 || under < 0) return {};
  const float t = (-wu - std::sqrt(under)) / uu;
  if (t > 1) return {};
  return t;
}
