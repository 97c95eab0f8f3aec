#include "stepped_bounce.hpp"

#include <cmath>
#include <string>

#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

namespace {

void require(bool fine, const std::string& what, double value, const std::string& rule) {
  if (!fine || !std::isfinite(value)) refuse("stepped bounce's " + what, value, "must be finite and " + rule);
}

}  // namespace

//! [stepped_bounce]
std::vector<Stepped> stepped_bounce(Stepper stepper, double height, double gravity, double restitution,
                                    double dt, std::size_t steps) {
  require(height >= 0, "height", height, "not negative");
  require(gravity >= 0, "gravity", gravity, "not negative");
  require(restitution >= 0 && restitution <= 1, "restitution", restitution, "from 0 to 1");
  require(dt > 0, "step", dt, "greater than zero");
  std::vector<Stepped> states{{0, height, 0}};
  for (std::size_t i = 1; i <= steps; ++i) {
    auto [time, y, v] = states.back();
    const double faster = v - gravity * dt;
    y += dt * (stepper == Stepper::explicit_euler ? v
               : stepper == Stepper::parabola     ? (v + faster) / 2
                                                  : faster);
    v = faster;
    if (y < 0) {
      y = 0;
      v = restitution * std::abs(v);
    }
    states.push_back({static_cast<double>(i) * dt, y, v});
  }
  return states;
}
//! [stepped_bounce]

}  // namespace first_contact
