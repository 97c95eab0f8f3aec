#pragma once
#include <cmath>

namespace first_contact {

/// a b + c, rounded once, from additions and products alone (Boldo and Melquiond, Emulation of a FMA and
/// Correctly Rounded Sums, IEEE Transactions on Computers 57, 2008), as long as no product leaves the range
/// of ordinary numbers: the product and its error, the sum of both parts with c, the small parts rounded to
/// odd, so that the last rounding sees on which side of a tie they lie.
double fused_in_software(double a, double b, double c);

/// a b + c, rounded once.
template <class Scalar>
Scalar fused(Scalar a, Scalar b, Scalar c) {
  using std::fma;
  return fma(a, b, c);
}

#if defined(_WIN32) && !defined(__FMA__)
/// The C library of MinGW rounds its own fma twice.
template <>
inline double fused(double a, double b, double c) {
  return fused_in_software(a, b, c);
}
#endif

}  // namespace first_contact
