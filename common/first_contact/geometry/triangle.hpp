#pragma once
#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// The triangle a b c; seen from the side of its normal its corners go round anticlockwise. It may be
/// degenerate.
struct Triangle {
  /// \throws std::invalid_argument if a corner is not finite, or beyond `largest_length`.
  Triangle(const Point& p, const Point& q, const Point& r) : a(p), b(q), c(r) {
    if (in_range(a) && in_range(b) && in_range(c))
      return;  // the usual case, in no time: the names below are made for nothing otherwise
    require_finite(a, "triangle's corner a");
    require_finite(b, "triangle's corner b");
    require_finite(c, "triangle's corner c");
  }

  /// (b - a) x (c - a): at right angles to the triangle, twice its area long; zero if it is degenerate.
  Vector area_vector() const;

  ///@{
  /// A corner.
  Point a, b, c;
  ///@}
};

}  // namespace first_contact
