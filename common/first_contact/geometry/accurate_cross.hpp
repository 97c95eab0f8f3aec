#pragma once
#include "first_contact/geometry/fused.hpp"
#include "first_contact/geometry/space.hpp"

namespace first_contact {

//! [difference_of_products]
/// a b - c d to within one and a half units in its last place, however much of it cancels: a fused
/// multiply-add gives what the rounding of c d left out (Kahan; proof: Jeannerod, Louvet and Muller,
/// Mathematics of Computation 82, 2013).
template <class Scalar>
EIGEN_ALWAYS_INLINE Scalar difference_of_products(Scalar a, Scalar b, Scalar c, Scalar d) {
  const Scalar cd = c * d;
  const Scalar left_out = fused(-c, d, cd);
  return fused(a, b, -cd) + left_out;
}
//! [difference_of_products]

/// a x b with each coordinate right to one and a half units in its last place. The plain formula is off by
/// that much of |a| |b|, which is everything if a and b are long and nearly parallel.
template <class Scalar>
EIGEN_ALWAYS_INLINE Vector3<Scalar> accurate_cross(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {difference_of_products(a.y(), b.z(), a.z(), b.y()),
          difference_of_products(a.z(), b.x(), a.x(), b.z()),
          difference_of_products(a.x(), b.y(), a.y(), b.x())};
}

}  // namespace first_contact
