#pragma once
#include <concepts>
#include <limits>
#include <optional>
#include <vector>

#include "first_contact/geometry/largest_coordinate.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Where a motion towards `p2` ends if a wall stops it at `q` and it slides on (paper, 2.2):
/// P3 = P2 - [(P2 - Q).N] N, the foot of the perpendicular from P2 to the wall moved out by the radius.
/// \param q  the sphere's *centre* at contact, not the point that is touched, or it ends up half sunk
/// \param n  the wall's unit normal at contact
Point slide_target(const Point& p2, const Point& q, const Vector& n);

//! [slide_result]
/// Why a slide ends.
enum class Ending {
  arrived,   ///< all of the motion was made, or slid along walls
  cornered,  ///< every way on leads into a wall, or not forwards
  exhausted  ///< more contacts than were allowed: the sphere stands at the last one
};

/// The path of a sphere that slides along what it meets.
struct Slide {
  std::vector<Point> positions;   ///< of the centre: the start, each corner of the path, the end
  std::vector<Contact> contacts;  ///< in order; the time is that of the whole motion, in [0, 1]
  /// Why it ends there.
  Ending ending;

  /// Where the centre ends.
  const Point& end() const { return positions.back(); }
};
//! [slide_result]

/// How near to a wall a sphere stops, measured along the wall's normal, in units of the largest coordinate of
/// the scene. A sweep places the sphere on the wall with an error of a few eps of that, moving it there adds
/// one, and the way on, at right angles to the normal but for rounding, may sink by up to 9 eps: 1.5 for the
/// product (P2 - Q).N, as much for N.V in the next sweep, 2 for the length of N and 1 for the rounding of V,
/// times sqrt(3), by which the length of V may exceed its largest coordinate. It is little enough not to be
/// seen, and to add up to nothing, as it is kept, not added, at each contact.
/// \see tests/property/slide_mesh.cpp
inline constexpr double slide_gap = 16 * std::numeric_limits<double>::epsilon();

/// Two normals at a smaller angle (in radians) are of one wall: their cross product, the crease, has lost
/// half of its digits, being known to eps / angle.
/// \see tests/unit/slide.cpp
inline constexpr double slide_same_wall = 0x1p-26;

/// Moves a sphere and lets it slide along whatever it meets, wall after wall. At each contact
/// - it stops `slide_gap` before the wall, back along its own path, and what is left of the motion, P2 - Q,
///   becomes P3 - Q (see slide_target);
/// - where it touches several walls at once, it becomes the nearest motion that leads into none of them:
///   along one wall, along the crease of two, or, in a corner, none;
/// - a way on that is not forwards, but at right angles to the wished motion or against it, is not taken.
///
/// The sphere never comes nearer to anything than its radius, but for the rounding of its end where that
/// happens to be next to something that it did not meet. It never goes through anything, never further than
/// asked, and never back, all but for the gap. If it overlaps something at the start, it gets no deeper.
///
/// \param largest_coordinate  of the environment: the rounding of a sweep is relative to it
/// \param most_contacts  how often it may meet something before it stops for good
Slide slide(const Moving<Sphere>& moving, const SphereSweep& first_contact_of, double largest_coordinate,
            int most_contacts = 64);

/// Slides along any obstacle at rest: whatever `sweep(moving, obstacle)` and `largest_coordinate(obstacle)` are
/// written for.
template <Obstacle Any>
requires requires(const Any& obstacle) {
  { largest_coordinate(obstacle) } -> std::convertible_to<double>;
}
Slide slide(const Moving<Sphere>& moving, const Any& obstacle) {
  return slide(
      moving, [&](const Moving<Sphere>& part) { return sweep(part, obstacle); },
      largest_coordinate(obstacle));
}

}  // namespace first_contact
