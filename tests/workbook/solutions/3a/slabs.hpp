#include "task.hpp"

static bool cut(Stay& stay, double least, double most, double s, double v) {
  if (v == 0) return s >= least && s <= most;
  const double a = (least - s) / v, b = (most - s) / v;
  stay.enters = std::max(stay.enters, std::min(a, b));
  stay.leaves = std::min(stay.leaves, std::max(a, b));
  return stay.enters <= stay.leaves;
}

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  Stay stay{0, 1};
  if (cut(stay, box.least.x, box.most.x, S0.x, V.x) && cut(stay, box.least.y, box.most.y, S0.y, V.y) &&
      cut(stay, box.least.z, box.most.z, S0.z, V.z))
    return stay;
  return {};
}
