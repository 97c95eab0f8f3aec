#include "first_contact/geometry/fused.hpp"

#include <bit>
#include <cstdint>
#include <limits>

namespace first_contact {

namespace {

/// A sum or a product: what it is rounded to, and what the rounding left out, exactly.
struct Exact {
  double rounded, rest;
};

// Knuth, The Art of Computer Programming 2, 4.2.2.
Exact sum(double a, double b) {
  const double s = a + b, of_b = s - a;
  return {s, (a - (s - of_b)) + (b - of_b)};
}

// Of a number the upper 26 bits, and the others (Veltkamp).
Exact halves(double a) {
  const double shifted = (0x1p27 + 1) * a, upper = shifted - (shifted - a);
  return {upper, a - upper};
}

// Dekker, Numerische Mathematik 18, 1971.
Exact exact_product(double a, double b) {
  const double p = a * b;
  const auto [a1, a2] = halves(a);
  const auto [b1, b2] = halves(b);
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

// a + b, rounded to the neighbour whose last bit is 1 unless it is exact.
double sum_rounded_to_odd(double a, double b) {
  const auto [s, rest] = sum(a, b);
  const bool odd = std::bit_cast<std::uint64_t>(s) & 1U;
  if (rest == 0 || odd) return s;
  return std::nextafter(
      s, rest > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity());
}

}  // namespace

double fused_in_software(double a, double b, double c) {
  const auto [p, p_rest] = exact_product(a, b);
  const auto [low, low_rest] = sum(c, p_rest);
  const auto [high, high_rest] = sum(p, low);
  return high + sum_rounded_to_odd(low_rest, high_rest);
}

}  // namespace first_contact
