#pragma once
#include <array>

#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// An oriented box (paper, 1.3): its centre and its three axes R, S, T, at right angles to each other, each
/// as long as the box is in that direction. A box may be flat (an axis of length 0).
struct Box {
  /// \throws std::invalid_argument if a coordinate or the sum of the lengths is not finite, or two axes
  ///         are not perpendicular.
  Box(const Point& q, const Vector& along_r, const Vector& along_s, const Vector& along_t);

  /// r_eff = 1/2 (|R.N| + |S.N| + |T.N|): how far the box reaches from its centre along a unit vector (paper,
  /// 1.3).
  double effective_radius(const Vector& unit) const;
  /// The eight vertices Q +- R/2 +- S/2 +- T/2; bits 0, 1, 2 of the number give the signs of R, S, T.
  std::array<Point, 8> vertices() const;

  /// The largest cosine between two axes that still counts as perpendicular: half a unit of the seventh
  /// digit, which is what axes typed with seven digits have.
  /// \see tests/unit/box.cpp
  static constexpr double perpendicular_tolerance = 5e-7;

  Point center;  ///< Q
  ///@{
  /// An axis, as long as the box is.
  Vector r, s, t;
  ///@}
};

}  // namespace first_contact
