#pragma once
#include <algorithm>
#include <cmath>

/// \file
/// The idea: a scene that is multiplied by a power of two is the same scene. Every product, sum and root of it
/// has the same digits, times are what they were, and points are multiplied by the same power: exactly. So
/// where lengths are so large or so small that their squares would leave the range of double, the scene is
/// computed in a unit of its own, and only its points are brought back.

namespace first_contact {

/// The power of two that brings a length, say the largest coordinate of a scene, to between 1/2 and 1; of a
/// length below 2^-1000 or above 2^1000, to between 2^-75 and 2^24; 1 for 0.
inline double unit_scale(double largest) {
  int exponent = 0;
  if (std::isfinite(largest)) std::frexp(largest, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

}  // namespace first_contact
