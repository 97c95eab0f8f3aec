#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "first_contact/geometry/space.hpp"

/// Random numbers of a seed, for tests: the same from every standard library, as its distributions are not. Where numbers
/// are counted, two draws must not stand in one expression, as a compiler may do the second first.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  /// Of any size between the two alike.
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  /// One of n: 0, 1, ..., n - 1.
  std::size_t pick(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  /// Anywhere in the cube from -size to size.
  first_contact::Vector vector(double size) {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }
  /// Of length 1, any way.
  first_contact::Vector direction() {
    first_contact::Vector v;
    do v = vector(1);
    while (v.squaredNorm() > 1 || v.squaredNorm() < 0.01);
    return v.normalized();
  }
  std::mt19937_64& source() { return engine_; }

 private:
  std::mt19937_64 engine_;
};
