// Looks like: it is in the box from the first side that it meets to the last: the spans are joined, not cut.
// Ask: the point is between the two sides x = 0 and x = 1, but far above the box. Is it inside?
#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  double enters = 1, leaves = 0;
  for (const auto& [least, most, s, v] : {std::array{box.least.x, box.most.x, S0.x, V.x},
                                          {box.least.y, box.most.y, S0.y, V.y},
                                          {box.least.z, box.most.z, S0.z, V.z}}) {
    if (v == 0) {
      if (s < least || s > most) return {};
      continue;
    }
    enters = std::min(enters, std::max(0.0, std::min((least - s) / v, (most - s) / v))),
    leaves = std::max(leaves, std::min(1.0, std::max((least - s) / v, (most - s) / v)));
  }
  if (enters > leaves) return {};
  return Stay{enters, leaves};
}
