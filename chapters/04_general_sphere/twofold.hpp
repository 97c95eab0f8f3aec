#pragma once
#include <array>
#include <cmath>

/// Numbers with twice the digits of a double, to judge doubles by: the same bits on every computer, which the
/// longer types of processors and compilers do not promise.

namespace general_sphere_chapter {

//! [twofold]
/// The sum of two doubles, the second of which is at most half a unit in the last place of the first
/// (Dekker 1971).
struct Twofold {
  Twofold(double value = 0, double rest = 0) : high(value), low(rest) {}
  double high, low;
};

/// a + b: what the rounding of the sum left out is itself a double (Knuth).
inline Twofold exact_sum(double a, double b) {
  const double sum = a + b, b_seen = sum - a;
  return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}
inline Twofold operator+(const Twofold& a, const Twofold& b) {
  const Twofold high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
  const Twofold sum = exact_sum(high.high, high.low + low.high);
  return exact_sum(sum.high, sum.low + low.low);
}
inline Twofold operator-(const Twofold& a, const Twofold& b) { return a + Twofold(-b.high, -b.low); }
inline Twofold operator*(const Twofold& a, const Twofold& b) {
  const double product = a.high * b.high, left_out = std::fma(a.high, b.high, -product);
  return exact_sum(product, left_out + (a.high * b.low + a.low * b.high));
}
inline Twofold operator/(const Twofold& a, const Twofold& b) {
  const double about = a.high / b.high;
  return Twofold(about) + Twofold((a - b * Twofold(about)).high / b.high);
}
inline Twofold root(const Twofold& a) {
  const double about = std::sqrt(a.high);
  if (about == 0) return {};
  return Twofold(about) + Twofold((a - Twofold(about) * Twofold(about)).high / (2 * about));
}
//! [twofold]

using Three = std::array<Twofold, 3>;

inline Twofold dot(const Three& a, const Three& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Three cross(const Three& a, const Three& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace general_sphere_chapter
