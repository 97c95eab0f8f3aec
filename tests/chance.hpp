#pragma once
#include <random>

#include "first_contact/geometry/space.hpp"

/// Random numbers of a seed, for tests.
class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  /// Anywhere in the cube from -size to size.
  first_contact::Vector vector(double size) {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }
  std::mt19937& source() { return random_; }

 private:
  std::mt19937 random_;
};
