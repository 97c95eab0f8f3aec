#pragma once
#include <cmath>
#include <cstdint>

#include "first_contact/geometry/space.hpp"

namespace digest {

using first_contact::Point;
using first_contact::Vector;

/// Random numbers that are the same on every machine: whole numbers (Steele, Lea and Flood's SplitMix64,
/// 2014), divided by powers of two. The distributions of the standard library are each library's own affair,
/// and the order of arguments each compiler's: what is asked for twice in one expression stands within
/// braces, which keep it.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// One of n.
  int pick(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  /// From low to high, both included.
  int whole(int low, int high) { return low + pick(high - low + 1); }
  /// In [0, 1), all 53 bits of it.
  double part() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  bool one_in(int n) { return pick(n) == 0; }

  /// A coordinate of about 1: on a grid, on it but for a few last bits, or anywhere.
  double coordinate() {
    const double on_grid = whole(-8, 8) / 4.0;
    switch (pick(3)) {
      case 0:
        return on_grid;
      case 1:
        return on_grid + whole(-4, 4) * 0x1p-51;
      default:
        return 4 * part() - 2;
    }
  }
  /// A vector of about 1, often along an axis or in a plane of two; never zero.
  Vector vector() {
    for (;;) {
      Vector v{coordinate(), coordinate(), coordinate()};
      if (one_in(3)) v[pick(3)] = 0;
      if (one_in(4)) v[pick(3)] = 0;
      if (!v.isZero(0)) return v;
    }
  }
  Point point() { return {coordinate(), coordinate(), coordinate()}; }
  /// A length of about 1, or 0.
  double length() { return one_in(8) ? 0 : std::abs(coordinate()); }

  /// The unit of a scene: 1 as a rule, or a very large or small power of two.
  double scale() { return one_in(4) ? std::ldexp(1.0, whole(-64, 64)) : 1.0; }

 private:
  std::uint64_t state_;
};

}  // namespace digest
