#include "printed_bounce.hpp"

#include <cmath>
#include <string>

#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

namespace {

void require(bool fine, const std::string& what, double value, const std::string& rule) {
  if (!fine || !std::isfinite(value)) refuse("bounce's " + what, value, "must be finite" + rule);
}

void require_sound(const PrintedBounce& b) {
  require(true, "v0", b.v0, "");
  require(b.y0 >= 0, "y0", b.y0, " and not negative");
  require(b.g >= 0, "g", b.g, " and not negative");
  require(b.dt > 0, "dt", b.dt, " and greater than zero");
  require(b.restitution >= 0 && b.restitution <= 1, "restitution", b.restitution, " and from 0 to 1");
  if (b.samples == 0) refuse("bounce's samples 0", "must be at least 1");
}

[[noreturn]] void refuse_overflow(std::size_t sample) {
  refuse("bounce", "the height at sample " + std::to_string(sample) + " must be finite");
}

}  // namespace

//! [printed_bounce]
PrintedMotion run(const PrintedBounce& bounce) {
  require_sound(bounce);
  PrintedMotion motion{{0}, {bounce.y0}, {}};
  double v0 = bounce.v0;
  double dT = bounce.dt;
  for (std::size_t i = 2; i <= bounce.samples; ++i) {
    const double t = motion.t.back() + bounce.dt;
    const double dy = v0 * bounce.dt - bounce.g * t * dT;
    double y = motion.y.back() - dy;
    if (!std::isfinite(y)) refuse_overflow(i);
    if (y < 0) {
      motion.hits.push_back({i, t, dy / bounce.dt});
      y = 0;
      v0 = -bounce.restitution * v0;
      dT = (-6.0 / 5) * bounce.dt;
    }
    motion.t.push_back(t);
    motion.y.push_back(y);
  }
  return motion;
}
//! [printed_bounce]

std::vector<Apex> apexes(const PrintedMotion& motion) {
  std::vector<Apex> list;
  const auto& y = motion.y;
  for (std::size_t i = 1; i + 1 < y.size(); ++i)
    if (y[i] > y[i - 1] && y[i] >= y[i + 1]) list.push_back({motion.t[i], y[i]});
  return list;
}

std::optional<double> rest_time(const PrintedMotion& motion) {
  std::size_t i = motion.y.size();
  while (i > 0 && motion.y[i - 1] == 0) --i;
  return i < motion.y.size() ? std::optional(motion.t[i]) : std::nullopt;
}

}  // namespace first_contact
