#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "first_contact/geometry/space.hpp"
#include "first_contact/program/random.hpp"

/// Random numbers of a seed, for tests: the same from every standard library, but for the last bits of its exp and log. Where
/// numbers are counted, two draws must not stand in one expression, as a compiler may do the second first.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : random_(seed) {}

  double uniform(double low, double high) { return random_.number(low, high); }
  /// Of any size between the two alike.
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  /// One of n: 0, 1, ..., n - 1.
  std::size_t pick(std::size_t n) { return static_cast<std::size_t>(random_.below(static_cast<int>(n))); }
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
  /// Any order is as likely as any other (Durstenfeld 1964).
  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t left = values.size(); left > 1; --left) std::swap(values[left - 1], values[pick(left)]);
  }

 private:
  first_contact::program::Random random_;
};
