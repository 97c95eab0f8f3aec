#pragma once
#include <algorithm>
#include <cmath>

#include "first_contact/geometry/space.hpp"

/// \file
/// The idea: a scene that is multiplied by a power of two is the same scene. Every product, sum and root of
/// it has the same digits, times are what they were, and points are multiplied by the same power: exactly. So
/// where lengths are so large or so small that their products would leave the range of double, the question
/// is asked in a unit of its own, and only the points of the answer are brought back.

namespace first_contact {

/// The power of two that brings a length, say the largest coordinate of a scene, to between 1/2 and 1; of a
/// length below 2^-1000 or above 2^1000, to between 2^-75 and 2^24; 1 for 0.
inline double unit_scale(double largest) {
  int exponent = 0;
  if (std::isfinite(largest)) std::frexp(largest, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

/// The same where something of that size lies at coordinates up to `reach`: these must not overflow either.
/// What is smaller than its coordinates by more than 2^900 keeps a size that is not ordinary.
inline double unit_scale(double size, double reach) {
  return std::min(unit_scale(size), 0x1p900 * unit_scale(reach));
}

/// Does a size need no other unit? The longest products of a sweep are of eight lengths, and some lengths may
/// well be much smaller than the largest.
inline bool is_ordinary(double size) { return size >= 0x1p-80 && size <= 0x1p80; }
/// The same of a product of two lengths, each of which may be anything.
inline bool is_ordinary_square(double square) {
  return std::abs(square) > 0x1p-900 && std::abs(square) < 0x1p900;
}

/// The largest coordinate, without its sign.
inline double largest(const Vector& v) { return v.cwiseAbs().maxCoeff(); }
/// The largest of three.
inline double largest(const Vector& a, const Vector& b, const Vector& c) {
  return a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs()).maxCoeff();
}

/// Is the vector at most d long?
bool within(const Vector& v, double d);

}  // namespace first_contact
