#pragma once
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// How far a shape may turn, in radians: some 160 thousand times round. A part of its time still has the digits that a
/// step needs, 2^-25 of a radian.
inline constexpr double largest_turn = 1e6;

/// A shape at t = 0 that turns about an axis, evenly, over t in [0, 1]; the axis may move, evenly too.
template <class Shape>
struct Turning {
  /// \param hinge  a point of the axis at t = 0
  /// \param direction  of the axis, of any length; the turn is anticlockwise as seen from its tip
  /// \param by  the angle at t = 1, in radians, at most `largest_turn` in size
  /// \param moved  how far the axis moves until t = 1
  /// \throws std::invalid_argument if the direction is zero, the angle larger, or a value is not finite.
  Turning(Shape s, const Point& hinge, const Vector& direction, double by,
          const Vector& moved = Vector::Zero())
      : shape(std::move(s)), center(hinge), axis(normalized(direction)), angle(by), displacement(moved) {
    require_finite(center, "hinge");
    require_finite(direction, "axis");
    require_finite(displacement, "displacement");
    if (direction.isZero(0)) refuse("axis 0, 0, 0", "must not be zero");
    if (!(std::abs(angle) <= largest_turn)) refuse("angle", angle, "must be at most 1e6 in size");
  }

  Shape shape;          ///< where it is at t = 0
  Point center;         ///< a point of the axis at t = 0
  Vector axis;          ///< unit
  double angle;         ///< from t = 0 to t = 1, in radians
  Vector displacement;  ///< of the axis, from t = 0 to t = 1
};

/// Two meshes of which one turns count as touching from this distance on, in units of the scene: of the largest
/// distance of any vertex of the two from the hinge, and the way of the hinge. It must be well above the rounding
/// of a turned vertex and of a distance, 16 eps or so, and it sets the price of a near miss: a part that turns by at
/// a distance just above it takes some 1 / sqrt(2^-24) = 4096 steps a radian. One that keeps its distance, a lid
/// that turns on its box or a drawer in its case, is seen not to come nearer, and takes a few each time that another
/// corner or edge is nearest. In each step the fastest point may go half of the gap, so the search ends.
/// \see tests/unit/turning_mesh.cpp
inline constexpr double turning_gap = 0x1p-24;

/// The normal between two surfaces that are nearer than this, in units of the scene, has no digits left; they touch.
/// Its error is 16 eps divided by their distance.
inline constexpr double turning_touch = 0x1p-40;

/// From when on a turning body is in contact.
struct Closeness {
  double gap;                 ///< at this distance, in the unit of the scene
  bool also_leaving = false;  ///< also where it moves away, or along
};

/// The first contact of a mesh that turns and moves, found by conservative advancement: when two triangles are d
/// apart and no point of the first is faster than V + R a (V the way of the hinge, a the angle, R how far it is from
/// the axis at most), they cannot meet before the time d / (V + R a). So we go on by the least of these times,
/// for distances less by half of the gap, measure again, and stop when a distance is within the gap. Nothing is ever passed over.
///
/// Nor can they before what is left of d along their normal, for each corner by its own rate and a bound of how the
/// turn bends it (course.hpp), is used up: where that time is longer, it is taken.
///
/// The time is never later than the true one but for rounding, and earlier by what the part needs to come nearer by
/// the gap. What is within the gap is in contact if it comes nearer still, and leaves or goes along if not; then a
/// bound of its acceleration tells how far it may go on before it is `gap / 2` deep. What touches to within
/// `turning_touch` of the scene, or crosses, is in contact wherever it goes. The normal points from the obstacle to
/// the mover; if they cross, against the motion.
std::optional<Contact> sweep(const Turning<Mesh>& turning, const Mesh& obstacle, const Closeness& close);
/// The same with `turning_gap` of the scene.
std::optional<Contact> sweep(const Turning<Mesh>& turning, const Mesh& obstacle);

/// The surface of a box: twelve triangles, seen from outside anticlockwise. Its vertices have the box's numbers.
Mesh surface_of(const Box& box);

/// A box that turns is swept by its surface: one that floats inside of a closed mesh does not touch it.
inline Turning<Mesh> by_surface(const Turning<Box>& turning) {
  return {surface_of(turning.shape), turning.center, turning.axis, turning.angle, turning.displacement};
}
/// First contact of a box that turns with a mesh.
inline std::optional<Contact> sweep(const Turning<Box>& turning, const Mesh& obstacle) {
  return sweep(by_surface(turning), obstacle);
}
/// First contact of a mesh that turns with a box, by its surface.
inline std::optional<Contact> sweep(const Turning<Mesh>& turning, const Box& obstacle) {
  return sweep(turning, surface_of(obstacle));
}
/// First contact of a box that turns with another, by their surfaces.
inline std::optional<Contact> sweep(const Turning<Box>& turning, const Box& obstacle) {
  return sweep(by_surface(turning), surface_of(obstacle));
}

/// The mesh, each vertex multiplied by a factor.
Mesh scaled(const Mesh& mesh, double factor);
/// The mesh when it has turned and moved for a time t in [0, 1].
Mesh turned(const Turning<Mesh>& turning, double t);

}  // namespace first_contact
