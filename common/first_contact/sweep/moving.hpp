#pragma once
#include <concepts>
#include <utility>

#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// A shape at t = 0 and its displacement V over t in [0, 1]. The shape's name need not be said twice:
/// `Moving ball{Sphere{Point(0, 0, 3), 1}, Vector(0, 0, -4)}`.
template <class Shape>
struct Moving {
  /// \throws std::invalid_argument if the displacement is not finite, or longer than `largest_length`.
  Moving(Shape s, const Vector& v) : shape(std::move(s)), displacement(v) {
    require_finite(displacement, "displacement");
  }

  Shape shape;          ///< where it is at t = 0
  Vector displacement;  ///< V, from t = 0 to t = 1
};

/// A sum or a product of vectors is a point, too: `Moving{p + q, v}`.
template <class Sum>
requires std::derived_from<Sum, Eigen::MatrixBase<Sum>> Moving(Sum, const Vector&)
->Moving<Point>;

}  // namespace first_contact
