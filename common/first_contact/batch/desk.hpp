#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "first_contact/batch/loops.hpp"

/// \file
/// Two batches of spheres whose columns drive each other out of the processor's cache.
///
/// Large arrays begin, as a rule, at the same place of a page; their lines of one number then share one set of
/// the cache, which holds eight, and the fifteen columns of two batches drive each other out before they are
/// used. Read p ahead of q, and there are never more than eight. Gain, on columns of 20,000 that begin alike:
/// from 1.9 to 1.2 times the memory's own time with AVX-512, from 2.6 to 1.6 with AVX2.

namespace first_contact::batch {

/// How many doubles one line of the memory holds.
inline constexpr std::size_t line = 8;

/// Spheres that were read some lines ahead.
class Desk {
 public:
  /// How many spheres there is room for.
  static constexpr std::size_t ahead = 256;

  /// Reads a line of spheres, from the i-th on.
  void put(const Spheres& all, std::size_t i) {
    double* to = place(i);
    const double* const columns[] = {all.center.x,       all.center.y,       all.center.z,      all.radius,
                                     all.displacement.x, all.displacement.y, all.displacement.z};
    for (const double* column : columns) {
      std::memcpy(to, column + i, line * sizeof(double));
      to += line;
    }
  }
  /// The line that was read from the i-th on.
  Spheres take(std::size_t i) {
    const double* from = place(i);
    const auto column = [&](std::size_t number) { return from + number * line; };
    return {{column(0), column(1), column(2)}, column(3), {column(4), column(5), column(6)}};
  }

 private:
  double* place(std::size_t i) { return numbers_[i / line % (ahead / line)]; }

  alignas(64) double numbers_[ahead / line][7 * line];
};

/// At which of the 64 lines of a page an array begins.
inline std::size_t place_in_page(const double* array) {
  return reinterpret_cast<std::uintptr_t>(array) / 64 % 64;
}

/// Do more columns begin at one place of a page than the cache holds?
inline bool crowded(const Spheres& p, const Spheres& q, const double* times) {
  const double* const columns[] = {
      p.center.x,       p.center.y,       p.center.z,       p.radius,         p.displacement.x,
      p.displacement.y, p.displacement.z, q.center.x,       q.center.y,       q.center.z,
      q.radius,         q.displacement.x, q.displacement.y, q.displacement.z, times};
  for (const double* one : columns) {
    int here = 0;
    for (const double* other : columns) here += place_in_page(one) == place_in_page(other);
    if (here > 8) return true;
  }
  return false;
}

}  // namespace first_contact::batch
