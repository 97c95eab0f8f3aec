// Looks like: spans that do not overlap are not noticed: it leaves before it enters.
// Ask: what does enters = 0.5, leaves = 0.1 mean?
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
    enters = std::max(enters, std::min((least - s) / v, (most - s) / v)),
    leaves = std::min(leaves, std::max((least - s) / v, (most - s) / v));
  }
  return Stay{enters, leaves};
}
