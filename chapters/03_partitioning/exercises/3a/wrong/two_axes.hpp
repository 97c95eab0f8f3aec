// Looks like: the third pair of sides is left out.
// Ask: the point flies high above the box. Which of your spans knows of z?
#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  double enters = 0, leaves = 1;
  for (const auto& [least, most, s, v] :
       {std::array{box.least.x, box.most.x, S0.x, V.x}, {box.least.y, box.most.y, S0.y, V.y}}) {
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
