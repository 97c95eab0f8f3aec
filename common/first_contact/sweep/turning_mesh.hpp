#pragma once
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// A shape at t = 0 that turns about a fixed axis, evenly, over t in [0, 1].
template <class Shape>
struct Turning {
  /// \param hinge  a point of the axis
  /// \param direction  of the axis, of any length; the turn is anticlockwise as seen from its tip
  /// \param by  the angle at t = 1, in radians
  /// \throws std::invalid_argument if the direction is zero, or a value is not finite.
  Turning(Shape s, const Point& hinge, const Vector& direction, double by)
      : shape(std::move(s)), center(hinge), axis(normalized(direction)), angle(by) {
    require_finite(center, "hinge");
    require_finite(direction, "axis");
    if (direction.isZero(0)) refuse("axis 0, 0, 0", "must not be zero");
    if (!std::isfinite(angle)) refuse("angle", angle, "must be finite");
  }

  Shape shape;   ///< where it is at t = 0
  Point center;  ///< a point of the axis
  Vector axis;   ///< unit
  double angle;  ///< from t = 0 to t = 1, in radians
};

/// Two turning meshes count as touching from this distance on, in units of the scene: of the largest distance
/// of any vertex of the two from the hinge. It must be well above the rounding of a turned vertex and of a
/// distance, 16 eps or so, and it sets the price of a near miss: a part that goes by at a distance just above
/// it takes some 1 / sqrt(2^-24) = 4096 steps. A step turns by that part of a radian at the least, so the
/// search ends.
/// \see tests/unit/turning_mesh.cpp
inline constexpr double turning_gap = 0x1p-24;

/// The first contact of a mesh that turns, found by conservative advancement: when two triangles are d apart
/// and no point of the first is farther than R from the axis, they cannot meet before the angle d / R. So we
/// turn by the least of these angles, measure again, and stop when a distance is within `turning_gap`.
/// Nothing is ever passed over.
///
/// The time is never later than the true one but for rounding, and earlier by what the part needs to come
/// nearer by the gap. A mover that is that near at t = 0 is in contact at t = 0, wherever it turns. The
/// normal points from the obstacle to the mover; if they cross, against the motion.
std::optional<Contact> sweep(const Turning<Mesh>& turning, const Mesh& obstacle);

/// The mesh when it has turned for a time t in [0, 1].
Mesh turned(const Turning<Mesh>& turning, double t);

}  // namespace first_contact
