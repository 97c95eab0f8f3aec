#include "task.hpp"

std::optional<float> meet(const Float3& w, const Float3& u, float d) {
  const float uu = dot(u, u), wu = dot(w, u);
  if (wu >= 0) return {};
  const float near = -wu / uu;
  const Float3 c = cross(w, u), p = (1 / uu) * cross(u, c);
  const float half = (d * d - dot(p, p)) / uu;
  if (half < 0 || near - std::sqrt(half) > 1) return {};
  return near - std::sqrt(half);
}
