#pragma once
#include "first_contact/geometry/space.hpp"

/// \file
/// Products whose sums are added in the order that is written here: the same bits from every compiler, with
/// vector instructions and without. Eigen's own (dot, squaredNorm, sum, matrix times vector) add in the order
/// that suits the processor they are compiled for.
///
/// All of it is inlined where it is used, so that no linker can take what was compiled with a user's options
/// for what the library was compiled with. A public header uses it in templates alone.

namespace first_contact {

/// a.b: in the plane a_x b_x + a_y b_y; in space (a_x b_x + a_y b_y) + a_z b_z; of 4-vectors, by pairs,
/// (a_x b_x + a_z b_z) + (a_y b_y + a_w b_w).
template <class A, class B>
EIGEN_ALWAYS_INLINE typename A::Scalar dot(const Eigen::MatrixBase<A>& first,
                                           const Eigen::MatrixBase<B>& second) {
  constexpr int size = A::SizeAtCompileTime;
  static_assert(size == B::SizeAtCompileTime && (size == 2 || size == 3 || size == 4));
  const auto& a = first.eval();
  const auto& b = second.eval();
  if constexpr (size == 4) return (a[0] * b[0] + a[2] * b[2]) + (a[1] * b[1] + a[3] * b[3]);
  if constexpr (size == 3) return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
  if constexpr (size == 2) return a[0] * b[0] + a[1] * b[1];
}

/// |a|^2 = a.a.
template <class A>
EIGEN_ALWAYS_INLINE typename A::Scalar squared_norm(const Eigen::MatrixBase<A>& vector) {
  const auto& a = vector.eval();
  return dot(a, a);
}

/// M N, or M v, column by column: (m_0 n_0 + m_1 n_1) + m_2 n_2 ...
template <class M, class N>
EIGEN_ALWAYS_INLINE typename N::PlainObject product(const Eigen::MatrixBase<M>& left,
                                                    const Eigen::MatrixBase<N>& right) {
  const auto& m = left.eval();
  const auto& n = right.eval();
  typename N::PlainObject result;
  for (Eigen::Index j = 0; j < n.cols(); ++j) {
    result.col(j) = m.col(0) * n(0, j);
    for (Eigen::Index i = 1; i < m.cols(); ++i) result.col(j) += m.col(i) * n(i, j);
  }
  return result;
}

}  // namespace first_contact
