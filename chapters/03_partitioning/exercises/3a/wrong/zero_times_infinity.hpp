// Looks like: everything is divided by the motion, also by 0. Beside a side the infinities come out right;
// exactly on a side 0/0 is not a number, and what std::min and std::max make of that depends on the order of
// their arguments.
// Ask: S0.y = 0 is on the side y = 0, and V.y = 0. What is (0 - S0.y)/V.y?
// Seen in: Ray Tracing in One Weekend (RayTracing/raytracing.github.io#927); noonat/intersect#9
#include "task.hpp"

std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) {
  const auto span = [](double a, double b) { return std::pair{std::min(a, b), std::max(a, b)}; };
  const auto [x0, x1] = span((box.least.x - S0.x) / V.x, (box.most.x - S0.x) / V.x);
  const auto [y0, y1] = span((box.least.y - S0.y) / V.y, (box.most.y - S0.y) / V.y);
  const auto [z0, z1] = span((box.least.z - S0.z) / V.z, (box.most.z - S0.z) / V.z);
  const double enters = std::max(std::max(std::max(x0, y0), z0), 0.0),
               leaves = std::min(std::min(std::min(x1, y1), z1), 1.0);
  if (enters > leaves) return {};
  return Stay{enters, leaves};
}
