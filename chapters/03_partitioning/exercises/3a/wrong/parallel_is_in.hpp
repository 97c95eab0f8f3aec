// Looks like: an axis along which there is no motion is left out, and a path beside the box is said to be in
// it.
// Ask: the point never moves in y, and its y is not between the sides. Can it ever be inside?
#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  double enters = 0, leaves = 1;
  for (const auto& [least, most, s, v] : {std::array{box.least.x, box.most.x, S0.x, V.x},
                                          {box.least.y, box.most.y, S0.y, V.y},
                                          {box.least.z, box.most.z, S0.z, V.z}}) {
    if (v == 0) continue;
    enters = std::max(enters, std::min((least - s) / v, (most - s) / v)),
    leaves = std::min(leaves, std::max((least - s) / v, (most - s) / v));
  }
  if (enters > leaves) return {};
  return Stay{enters, leaves};
}
