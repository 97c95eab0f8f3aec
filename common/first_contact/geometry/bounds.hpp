#pragma once
#include <optional>
#include <span>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

/// The box with sides along the axes in which a thing lies: its bounding box (paper, 1.1). It contains its
/// own boundary, may be flat, and may be empty: that of nothing overlaps nothing, and grows with what it is
/// made to include. (In the name of its class, "aligned" is to the axes.)
using Bounds = Eigen::AlignedBox3d;

/// From the low corner to the high one.
/// \throws std::invalid_argument if a corner is not finite, or the low one is above the high one.
Bounds bounds_between(const Point& low, const Point& high);

/// The middle, also of a box so large that the sum of its corners overflows.
Point middle_of(const Bounds& box);
/// The largest coordinate of a corner, without its sign; 0 if it is empty.
double largest_coordinate(const Bounds& box);
/// Moved out by `distance` on all six sides.
Bounds grown(const Bounds& box, double distance);

/// The bounds of a thing contain all of it: where a coordinate has to be rounded, it is rounded outwards.
Bounds bounds_of(std::span<const Point> points);
/// Of a triangle.
Bounds bounds_of(const Triangle& triangle);
/// Of a sphere at rest.
Bounds bounds_of(const Sphere& sphere);
/// Of all that a moving sphere passes: around S0 and S0 + V.
Bounds bounds_of(const Sphere& sphere, const Vector& displacement);
/// Of a set of bounds.
Bounds bounds_of(std::span<const Bounds> all);
/// Of bounds: they themselves.
inline const Bounds& bounds_of(const Bounds& box) { return box; }

/// Do two boxes share a point? Touching counts: a side, an edge or a corner in common is enough.
bool overlap(const Bounds& a, const Bounds& b);
/// Do a triangle and a box share a point? Touching counts, up to rounding. They do not if one of 13
/// directions parts them: the box's three, the triangle's normal, and those at right angles to an edge of
/// each (Akenine-Moller, Fast 3D Triangle-Box Overlap Testing, 2001).
bool overlap(const Triangle& triangle, const Bounds& box);

/// A part of a motion: the times from `enter` to `leave`.
struct Passage {
  /// When it begins.
  double enter = 0;
  /// When it ends.
  double leave = 1;

  /// Does it end before it begins?
  bool empty() const { return !(enter <= leave); }
};

/// When is the moving point S0 + t V inside the box? The slabs between its three pairs of sides are each
/// entered and left once (Ericson, Real-Time Collision Detection, 5.3.3). Nothing if never within `part`.
///
/// A motion along a side is never divided by zero: 0 times infinity is not a number, and would lose the hit.
std::optional<Passage> passage(const Point& start, const Vector& displacement, const Bounds& box,
                               const Passage& part = {});

}  // namespace first_contact
