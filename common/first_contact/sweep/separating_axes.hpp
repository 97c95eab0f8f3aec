#pragma once
#include <limits>
#include <vector>

#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// Two convex polyhedra share no point if they lie apart along some direction, and then along one of a few:
/// the normals of their faces, and those at right angles to an edge of each (Gottschalk, Lin, Manocha, 1996).
/// While they move, each of these directions has an interval of time in which they do not lie apart along
/// it; they touch in what is common to all.

namespace first_contact {

/// A convex polyhedron as far as its directions of separation go: flat, a segment or a point as well.
struct Hull {
  /// Of a box.
  explicit Hull(const Box& box);
  /// Of a triangle, degenerate or not.
  explicit Hull(const Triangle& triangle);

  std::vector<Point> vertices;  ///< those of a face in a row, around it
  std::vector<Vector> normals;  ///< unit, of its faces
  std::vector<Vector> edges;    ///< unit, one for each direction that its edges have
  bool flat;                    ///< has it no inside?
};

/// A box about the origin. Whoever asks of two sees both from one of them, lest their corners round by eps of how far off
/// they are.
Hull about_origin(const Box& box);
/// The hull as seen from there.
Hull seen_from(const Point& origin, Hull hull);

/// The directions along which two hulls may be apart although they share no point: unit, the normals first.
std::vector<Vector> separating_axes(const Hull& a, const Hull& b);

/// Up to this part of the scene (all vertices' distances from the obstacle's first one, and the path) the
/// place of a projected vertex may be wrong by rounding: a difference of two points, of three products and a
/// unit direction whose own error is below 3 eps, 8 eps at the most; for both hulls.
/// \see tests/oracle/box_box.cpp
inline constexpr double rounding_of_projection = 16 * std::numeric_limits<double>::epsilon();

/// Do they share a point? Touching counts.
bool overlap(const Hull& a, const Hull& b);

/// The first contact of a hull that moves by V with one at rest, by the contract of every sweep. The point
/// is the middle of what they share, the feature what of the hull at rest is touched.
std::optional<Contact> sweep_hull(const Hull& moving, const Vector& displacement, const Hull& obstacle);

}  // namespace first_contact
