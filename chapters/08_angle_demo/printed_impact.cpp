#include "printed_impact.hpp"

#include <cmath>
#include <numbers>

namespace first_contact {

namespace {

double direction(const Eigen::Vector2d& v) { return to_degrees(std::atan2(v.y(), v.x())); }

PrintedImpact outcome(bool collides, const Eigen::Vector2d& v1, const Eigen::Vector2d& v2) {
  return {collides, {v1, v2}, {direction(v1), direction(v2)}};
}

/// dx, or 10^-12 |dy| with its sign if it is smaller than that: the listing's guard against a division by
/// zero.
double guarded(double dx, double dy) {
  const double least = 1e-12 * std::abs(dy);
  if (std::abs(dx) < least) return dx < 0 ? -least : least;
  return dx;
}

}  // namespace

double to_degrees(double radians) { return 180 / std::numbers::pi * radians; }

//! [printed_impact]
PrintedImpact printed_impact(const PrintedBody& one, const PrintedBody& two, double r) {
  const double ratio = two.mass / one.mass;
  const Eigen::Vector2d between = two.position - one.position;
  const Eigen::Vector2d approach = two.velocity - one.velocity;
  if (approach.dot(between) >= 0) return outcome(false, one.velocity, two.velocity);

  // The impulse along the line of centres, by way of its slope.
  const double a = between.y() / guarded(between.x(), between.y());
  const double change = -2 * (approach.x() + a * approach.y()) / ((1 + a * a) * (1 + ratio));
  const Eigen::Vector2d v2 = two.velocity + Eigen::Vector2d(change, a * change);
  const Eigen::Vector2d v1 = one.velocity - Eigen::Vector2d(ratio * change, a * ratio * change);

  // The "correction for inelastic collisions": all of the motion relative to the common centre of mass
  // shrinks by r.
  const Eigen::Vector2d common = (one.mass * one.velocity + two.mass * two.velocity) / (one.mass + two.mass);
  return outcome(true, (v1 - common) * r + common, (v2 - common) * r + common);
}
//! [printed_impact]

}  // namespace first_contact
