#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "first_contact/geometry/space.hpp"

/// Random numbers of a seed, for tests.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// Of any size between the two alike.
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  /// One of n: 0, 1, ..., n - 1.
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_); }
  /// Anywhere in the cube from -size to size.
  first_contact::Vector vector(double size) {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }
  /// Of length 1, any way.
  first_contact::Vector direction() {
    std::normal_distribution<double> normal;
    const double x = normal(engine_), y = normal(engine_), z = normal(engine_);
    return first_contact::Vector(x, y, z).normalized();
  }
  std::mt19937_64& source() { return engine_; }

 private:
  std::mt19937_64 engine_;
};
