#pragma once
#include <cstdint>
#include <random>
#include <vector>

#include "workbook/vectors.hpp"

namespace workbook {

/// The same random inputs everywhere: coarse numbers, which are short to read and exact in binary.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : bits_(seed) {}

  /// From 0 to n - 1.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits_() % n); }
  /// From `least` to `most`, in steps of 1/64.
  double number(double least, double most) {
    const auto steps = static_cast<std::size_t>((most - least) * 64);
    return least + static_cast<double>(below(steps + 1)) / 64;
  }
  Vector vector(double most) { return {number(-most, most), number(-most, most), number(-most, most)}; }
  Vector2 vector2(double most) { return {number(-most, most), number(-most, most)}; }
  /// One of a few.
  template <class T>
  const T& one_of(const std::vector<T>& few) {
    return few[below(few.size())];
  }
  /// A direction whose length is 1 to the last place or nearly.
  Vector unit() {
    static const std::vector<Vector> few{{0, 0, 1},          {0, -1, 0},        {0.6, 0, 0.8},
                                         {0, 0.6, -0.8},     {0.48, 0.6, 0.64}, {-0.8, 0.6, 0},
                                         {0.36, -0.48, 0.8}, {-0.28, 0, 0.96}};
    return one_of(few);
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace workbook
