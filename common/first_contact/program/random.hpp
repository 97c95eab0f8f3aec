#pragma once
#include <cstdint>
#include <random>

#include "first_contact/geometry/space.hpp"

/// \file
/// Random numbers that are the same on every computer. The standard lays down every bit of its generators,
/// but leaves the distributions to the library; so numbers are made of the bits here, by arithmetic that is
/// exact or rounded alike everywhere.

namespace first_contact::program {

/// A sequence of random numbers, told by its seed.
class Random {
 public:
  /// The sequence of that seed.
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  /// Evenly spread over [0, 1): 53 of the generator's 64 bits.
  double number() { return static_cast<double>(generator_() >> 11U) * 0x1p-53; }
  /// Evenly spread over [low, high).
  double number(double low, double high) { return low + (high - low) * number(); }
  /// Evenly spread over the unit cube.
  Vector vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  /// 0, 1, ..., count - 1.
  int below(int count) { return static_cast<int>(number() * count); }

 private:
  std::mt19937_64 generator_;
};

/// Evenly spread over [-1, 1].
inline double uniform(std::mt19937& random) { return static_cast<double>(random()) / 2147483647.5 - 1; }

/// Of length 1, its directions evenly spread: of the vectors of a cube those that are neither too long nor
/// too short, shortened or drawn out.
inline Vector unit_vector(std::mt19937& random) {
  Vector v;
  do v = {uniform(random), uniform(random), uniform(random)};
  while (v.squaredNorm() > 1 || v.squaredNorm() < 0.01);
  return v.normalized();
}

}  // namespace first_contact::program
