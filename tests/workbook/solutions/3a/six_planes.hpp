#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  const Plane sides[] = {{{1, 0, 0}, -box.least.x}, {{-1, 0, 0}, box.most.x},  {{0, 1, 0}, -box.least.y},
                         {{0, -1, 0}, box.most.y},  {{0, 0, 1}, -box.least.z}, {{0, 0, -1}, box.most.z}};
  double enters = 0, leaves = 1;
  for (const Plane& side : sides) {
    const double inside = dot(side, S0), way = dot(side.N, V);
    if (way == 0 && inside < 0) return {};
    if (way > 0) enters = std::max(enters, -inside / way);
    if (way < 0) leaves = std::min(leaves, -inside / way);
  }
  if (enters > leaves) return {};
  return Stay{enters, leaves};
}
