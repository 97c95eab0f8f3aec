// Looks like: everything is divided by the motion, also by 0; and where that gives no number, the path is
// said to miss.
// Ask: S0.y = 0 is on the side y = 0, and V.y = 0. Is the point in the box while it moves along that side?
// Seen in: noonat/intersect#9
#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  double enters = 0, leaves = 1;
  for (const auto& [least, most, s, v] : {std::array{box.least.x, box.most.x, S0.x, V.x},
                                          {box.least.y, box.most.y, S0.y, V.y},
                                          {box.least.z, box.most.z, S0.z, V.z}}) {
    const double a = (least - s) / v, b = (most - s) / v;
    if (std::isnan(a) || std::isnan(b)) return {};
    enters = std::max(enters, std::min(a, b)), leaves = std::min(leaves, std::max(a, b));
  }
  if (enters > leaves) return {};
  return Stay{enters, leaves};
}
