#pragma once
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/contact.hpp"

namespace first_contact {

/// Where a motion towards `p2` ends if a wall stops it at `q` and it slides on (paper, 2.2):
/// P3 = P2 - [(P2 - Q).N] N, the foot of the perpendicular from P2 to the wall moved out by the radius.
/// \param q  the sphere's *centre* at contact, not the point that is touched: that one would leave the sphere
/// half sunk. \param n  the wall's unit normal at contact.
Point slide_target(const Point& p2, const Point& q, const Vector& n);

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
  Ending ending;

  const Point& end() const { return positions.back(); }
};

/// The first contact of a sphere with an environment of any kind.
using SphereSweep = std::function<std::optional<Contact>(const Moving<Sphere>&)>;

/// How near to a wall a sphere stops, measured along the wall's normal, in units of eps times the largest
/// coordinate of the scene. A sweep places the sphere on the wall with an error of at most 8 such units,
/// moving it there adds one, and the path along the wall may sink by `slide_lean` less than nothing: twice
/// the first keeps it outside. \see tests/property/slide_test.cpp
inline constexpr double slide_gap = 16 * std::numeric_limits<double>::epsilon();

/// How much a direction along a wall leans outwards, relative to its length. N.V, for a V that is computed to
/// be at right angles to N, is off by up to 1.5 eps for the product (P2 - Q).N, as much for N.V itself, 2 eps
/// for the length of N and 1 eps for the rounding of V: with 8 eps a slide never counts as approaching the
/// wall that it slides along.
inline constexpr double slide_lean = 8 * std::numeric_limits<double>::epsilon();

/// Two normals at a smaller angle (in radians) are of one wall: their cross product, the crease, has lost
/// half of its digits, being known to eps / angle.
inline constexpr double slide_same_wall = 0x1p-26;

/// Moves a sphere and lets it slide along whatever it meets, wall after wall. At each contact
/// - it stops `slide_gap` before the wall, back along its own path, and the rest of the motion goes to
/// slide_target;
/// - where it touches several walls at once, the rest of the motion becomes the nearest one that leads into
/// none of
///   them: along one wall, along the crease of two, or, in a corner, none;
/// - a way on that is not forwards (at right angles to the wished motion, or against it) is not taken.
///
/// The sphere is never nearer to anything than its radius, but for the rounding of one addition; it never
/// goes through anything, never further than asked, and never back. If it overlaps something at the start, it
/// gets no deeper.
///
/// \param extent  the largest coordinate of the environment, which the rounding of a sweep is relative to.
/// \param most_contacts  how often it may meet something before it stops for good.
Slide slide(const Moving<Sphere>& moving, const SphereSweep& first_contact_of, double extent,
            int most_contacts = 64);

/// The largest coordinate that describes an obstacle: its scale, for `slide`.
inline double extent(const Plane& plane) { return std::abs(plane.offset()); }
double extent(const Triangle& triangle);
double extent(const Mesh& mesh);

/// Slides in any environment for which `sweep(moving, environment)` and `extent(environment)` exist.
template <class Environment>
Slide slide(const Moving<Sphere>& moving, const Environment& environment) {
  return slide(
      moving, [&](const Moving<Sphere>& part) { return sweep(part, environment); }, extent(environment));
}

}  // namespace first_contact
