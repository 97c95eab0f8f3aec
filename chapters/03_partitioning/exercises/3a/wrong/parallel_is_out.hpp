// Looks like: a motion along an axis is refused: whatever does not move in y or z misses.
// Ask: a point flies along x, through the middle of the box. What are its V.y and V.z?
#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  double enters = 0, leaves = 1;
  for (const auto& [least, most, s, v] : {std::array{box.least.x, box.most.x, S0.x, V.x},
                                          {box.least.y, box.most.y, S0.y, V.y},
                                          {box.least.z, box.most.z, S0.z, V.z}}) {
    if (v == 0) return {};
    enters = std::max(enters, std::min((least - s) / v, (most - s) / v)),
    leaves = std::min(leaves, std::max((least - s) / v, (most - s) / v));
  }
  if (enters > leaves) return {};
  return Stay{enters, leaves};
}
