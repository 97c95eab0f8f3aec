#pragma once
#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

/// A triangle together with what a sweep asks of its plane: one well-chosen corner and the normal there.
///
/// The normal is the cross product of the two shorter sides, which meet at the largest angle: however long
/// and thin the triangle is, no other choice is rounded less.
struct Facet {
  explicit Facet(const Triangle& t);

  /// Is the triangle too thin for its face to matter to a sphere of this radius? Then its edges answer for
  /// it.
  bool thin_for(double radius) const { return !(radius < largest_radius); }
  /// The normal, of unit length; zero if the triangle is degenerate.
  Vector unit_normal() const { return length > 0 ? Vector(normal / length) : Vector(Vector::Zero()); }

  Triangle triangle;
  Point corner;           ///< opposite the longest side
  Vector normal;          ///< at right angles to the triangle, twice its area long
  double length;          ///< |normal|
  double longest;         ///< the longest side
  double largest_radius;  ///< up to here the face answers for itself; 0 if the triangle is degenerate \see
                          ///< facet.cpp
};

}  // namespace first_contact
