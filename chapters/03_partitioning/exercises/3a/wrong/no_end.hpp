// Looks like: a ray and not a motion: what is beyond its end counts.
// Ask: the point stops half way to the box. Does it enter?
#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  double enters = 0, leaves = std::numeric_limits<double>::infinity();
  for (const auto& [least, most, s, v] : {std::array{box.least.x, box.most.x, S0.x, V.x},
                                          {box.least.y, box.most.y, S0.y, V.y},
                                          {box.least.z, box.most.z, S0.z, V.z}}) {
    if (v == 0) {
      if (s < least || s > most) return {};
      continue;
    }
    enters = std::max(enters, std::min((least - s) / v, (most - s) / v)),
    leaves = std::min(leaves, std::max((least - s) / v, (most - s) / v));
  }
  if (enters > leaves) return {};
  return Stay{enters, leaves};
}
