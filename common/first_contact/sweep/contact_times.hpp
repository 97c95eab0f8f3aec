#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "first_contact/geometry/accurate_cross.hpp"
#include "first_contact/geometry/products.hpp"

/// \file
/// When does a point w + t u come within d of the origin, and when does it leave? Twice the same quadratic
/// equation, |w + t u|^2 = d^2 (paper, 2.3), solved as printed and solved well. Templates, so that single
/// precision shows its worst.

namespace first_contact {

/// The paper's t1 and t2: when two spheres begin to touch, and when they part. Any real numbers, begin <=
/// end.
template <class Scalar>
struct ContactTimes {
  ///@{
  /// Contact, and separation.
  Scalar begin, end;
  ///@}
};

//! [textbook_times]
/// As printed: t = (-w.u -+ sqrt((w.u)^2 - u^2 (w^2 - d^2))) / u^2. Nothing if u is zero or the root is not
/// real.
///
/// Far away, (w.u)^2 and u^2 w^2 are huge and nearly equal: of their difference, only rounding errors remain.
template <class Scalar>
EIGEN_ALWAYS_INLINE std::optional<ContactTimes<Scalar>> textbook_times(const Vector3<Scalar>& w,
                                                                       const Vector3<Scalar>& u, Scalar d) {
  const Scalar a = squared_norm(u), b = dot(w, u), c = squared_norm(w) - d * d;
  const Scalar discriminant = b * b - a * c;
  if (!(a > 0) || !(discriminant >= 0)) return std::nullopt;
  using std::sqrt;
  const Scalar root = sqrt(discriminant);
  return ContactTimes<Scalar>{(-b - root) / a, (-b + root) / a};
}
//! [textbook_times]

//! [discriminant]
/// (w.u)^2 - u^2 (w^2 - d^2) without the cancellation. By Lagrange's identity, (w.u)^2 = w^2 u^2 - |w x u|^2:
/// what remains is u^2 d^2 - |w x u|^2, that is, u^2 times (d^2 less the square of the distance at the
/// closest approach).
/// \param moment w x u, the same for every w on the path.
template <class Scalar>
EIGEN_ALWAYS_INLINE Scalar discriminant(const Vector3<Scalar>& u, const Vector3<Scalar>& moment, Scalar d) {
  return squared_norm(u) * (d * d) - squared_norm(moment);
}
//! [discriminant]

//! [contact_times]
/// The same two times by way of the closest approach. The root that would be a difference of nearly equal numbers
/// follows from the other, which is a sum, and from the product of both, c / a. Two differences are left: w^2 - d^2,
/// which cancels when the spheres nearly touch at the start, and u^2 d^2 - |w x u|^2, when they graze; h of the bound
/// below is small then. Both are as exact as their terms.
/// \param moment w x u, the same for every w on the path.
template <class Scalar>
EIGEN_ALWAYS_INLINE std::optional<ContactTimes<Scalar>> contact_times(const Vector3<Scalar>& w,
                                                                      const Vector3<Scalar>& u,
                                                                      const Vector3<Scalar>& moment,
                                                                      Scalar d) {
  using std::copysign, std::sqrt;
  const Scalar a = squared_norm(u), b = dot(w, u), c = squared_norm(w) - d * d;
  const Scalar D = discriminant(u, moment, d);
  if (!(a > 0) || !(D >= 0)) return std::nullopt;
  const Scalar sum = -b + copysign(sqrt(D), -b);    // not b's "sign" times the root: that of 0 must not be 0
  if (sum == 0) return ContactTimes<Scalar>{0, 0};  // grazing, just now
  const Scalar by_product = c / sum, by_sum = sum / a;
  return ContactTimes<Scalar>{std::min(by_product, by_sum), std::max(by_product, by_sum)};
}
//! [contact_times]

/// The same for a single w: its moment is w x u.
template <class Scalar>
EIGEN_ALWAYS_INLINE std::optional<ContactTimes<Scalar>> contact_times(const Vector3<Scalar>& w,
                                                                      const Vector3<Scalar>& u, Scalar d) {
  return contact_times(w, u, accurate_cross(w, u), d);
}

}  // namespace first_contact
