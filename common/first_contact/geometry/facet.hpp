#pragma once
#include <limits>

#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

/// By how much a computed distance between a moving sphere and a feature may be wrong, in units of eps
/// (distance of the centre from the feature's corner + length of the feature + path + r). The distance to an
/// edge is the worst: a difference, a cross product, the closest approach and the root add up to less than 8
/// eps of that. This is twice as much: what is wrong by 8 eps must be taken for a touch, and may in truth be
/// wrong by 8 eps more.
/// \see tests/oracle/sphere_triangle.cpp, tests/oracle/verify.cpp
inline constexpr double rounding_of_distance = 16 * std::numeric_limits<double>::epsilon();

/// The normal (b - a) x (c - a) of three points, computed at the corner with the largest angle, from the two
/// shorter sides: however long and thin the triangle is, no other corner rounds less.
struct CornerNormal {
  /// Of the points a, b, c; they may lie on one line.
  CornerNormal(const Point& a, const Point& b, const Point& c);

  Point corner;  ///< opposite the longest side
  /// At right angles to the triangle, twice its area long; zero if it is degenerate. Of the triangle that the
  /// rounded sides make it is wrong by less than 3.4 eps of its length.
  Vector normal;
  double longest;  ///< the longest side
  /// Both are those of the triangle multiplied by this power of two. It is 1, unless the triangle is so large
  /// or so small that its area would leave the range of double.
  double unit = 1;
};

/// A triangle together with what a sweep asks of its plane.
struct Facet : CornerNormal {
  /// Of any triangle, degenerate or not.
  explicit Facet(const Triangle& t);

  /// Is the triangle too thin for its face to matter to a sphere of this radius? Then its edges answer for
  /// it. Always so if it is degenerate.
  bool thin_for(double radius) const;
  /// Is the triangle no higher than what rounding, the tolerance, may take or add, and is the place beyond an end of its
  /// longest side? Where a path meets such a plane is known along that side alone: the signs of areas say nothing.
  bool is_beyond_needle(const Point& place, double tolerance) const;
  /// The normal, of unit length; zero if the triangle is degenerate.
  Vector unit_normal() const { return length > 0 ? Vector(normal / length) : Vector(Vector::Zero()); }

  /// The triangle itself.
  Triangle triangle;
  double length;  ///< |normal|
};

}  // namespace first_contact
