#pragma once
#include <array>

#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// One of the two bodies of the paper's program 4.
struct PrintedBody {
  /// m.
  double mass;
  ///@{
  /// At the start.
  Eigen::Vector2d position, velocity;
  ///@}
};

/// What program 4 makes of them.
struct PrintedImpact {
  bool collides;                            ///< the bodies approach; whether they ever meet is not asked
  std::array<Eigen::Vector2d, 2> velocity;  ///< after the impact
  std::array<double, 2> angle;              ///< of the velocities, in degrees, in (-180, 180]
};

/// The paper's program 4 as printed (2.4.2 (iii), 3.1.2): the same operations in the same order, so that the
/// printed angles come out to the last digit. Its faults are kept, for chapter 8 to show; impact() is the
/// remedy:
/// - It tests whether the bodies approach, not whether they meet.
/// - It takes the normal from one start to the other, not at contact.
/// - What it calls the radius of the objects, r, acts as the coefficient of restitution.
/// - With r < 1 it slows the velocities across the normal as well, as if the bodies also dragged.
/// - The normal enters as its slope, a = dy / dx: if dx is 0, then a is taken as 10^12 instead; if that dx
///   underflows to 0 too, the velocities are not numbers. Bodies at one place never collide.
///
/// Masses, positions and velocities are taken as they come, as in the listing.
PrintedImpact printed_impact(const PrintedBody& one, const PrintedBody& two, double r);

/// An angle in degrees: radians times (180 / pi).
double to_degrees(double radians);

}  // namespace first_contact
