#pragma once
#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// A plane E = [N, D]: all points Q with N.Q + D = 0 (paper, 1.2). N has unit length by construction, so that
/// E.Q is the signed distance of Q, positive on the side to which N points.
class Plane {
 public:
  /// The plane N.Q + D = 0 for any non-zero normal; both are divided by the length of the normal.
  /// \throws std::invalid_argument if the normal is zero, or a coefficient is not finite.
  Plane(const Vector& normal, double offset);

  /// The plane through `point` at right angles to `normal`: D = -N.P (paper, 1.2).
  static Plane through(const Point& point, const Vector& normal);

  /// N, of unit length.
  Vector normal() const { return coefficients_.head<3>(); }
  /// D, the signed distance of the origin.
  double offset() const { return coefficients_.w(); }
  /// E = [N, D] as a 4-vector.
  const Homogeneous& coefficients() const { return coefficients_; }
  /// E.Q = N.Q + D, the signed distance of a point (paper, 1.2).
  double signed_distance(const Point& q) const;
  /// E' = [N, D - r], this plane moved by `distance` along its normal (paper, 1.2).
  /// \throws std::invalid_argument if that is no number, or farther from the origin than 2^1002.
  Plane moved_out(double distance) const;

 private:
  Homogeneous coefficients_;
};

}  // namespace first_contact
