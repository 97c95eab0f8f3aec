#pragma once
#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// All points at most `radius` from `center`. A sphere of radius 0 is a point.
struct Sphere {
  /// \throws std::invalid_argument if the centre is not finite, or the radius is negative or not finite.
  Sphere(const Point& s, double r) : center(s), radius(r) {
    require_finite(center, "sphere's centre");
    require_length(radius, "sphere's radius");
  }

  Point center;   ///< S
  double radius;  ///< r, not negative
};

}  // namespace first_contact
