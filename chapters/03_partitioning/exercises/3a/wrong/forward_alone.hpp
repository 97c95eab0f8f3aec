// Looks like: it goes in at `least` and out at `most`: right while the motion is toward larger x, y and z.
// Ask: coming from the right, which side does one meet first?
#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  double enters = 0, leaves = 1;
  for (const auto& [least, most, s, v] : {std::array{box.least.x, box.most.x, S0.x, V.x},
                                          {box.least.y, box.most.y, S0.y, V.y},
                                          {box.least.z, box.most.z, S0.z, V.z}}) {
    if (v == 0) {
      if (s < least || s > most) return {};
      continue;
    }
    enters = std::max(enters, (least - s) / v), leaves = std::min(leaves, (most - s) / v);
  }
  if (enters > leaves) return {};
  return Stay{enters, leaves};
}
