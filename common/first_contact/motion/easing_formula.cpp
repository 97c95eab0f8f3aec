#include "first_contact/motion/easing_formula.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace first_contact::ease::formula {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

// A smaller b than 2^-60 bends it by less than a rounding, and may itself have no digits left.
double exponential(double t, double b) {
  if (std::abs(b) < 0x1p-60) return t;
  return std::expm1(b * std::numbers::ln2 * t) / (b == 10 ? 1023 : std::expm1(b * std::numbers::ln2));
}

double back(double t, double overshoot) { return t * t * (t - overshoot * (1 - t)); }

double elastic(double t, double amplitude, double period) {
  const double turn = 20 * pi / 3 * (0.3 / period) * (1 - t);  // 2 pi / 0.3 is 20 pi / 3
  return amplitude * exponential(t) * std::cos(turn - std::acos(1 / amplitude));
}

namespace {

double one_less_exp(double x) { return -std::expm1(-x); }

// While the faster of its two exponents is at most 1: s^2 (1/2! - h1/3! + h2/4! - ...), where h_m = 2 c h_(m-1) - s^2
// h_(m-2) is the sum of all products of m of the two exponents, whose sum is 2 c and whose product is s^2. It is
// m + 1 at most, so that the 18th term is below the rounding.
double slow_spring(double s, double c) {
  double sum = 0, part = 0.5, h = 1, h_before = 0;
  for (int m = 0; m < 18; ++m) {
    sum += part * h;
    part /= -(m + 3);
    h_before = std::exchange(h, 2 * c * h - s * s * h_before);
  }
  return s * s * sum;
}

// 1 - e^-c (cos b + c sin b / b); while little has decayed, as a sum in which nothing cancels.
double swinging_spring(double c, double b) {
  const double half = std::sin(b / 2), decayed = std::exp(-c), slope = std::sin(b) / b;
  if (c >= 1) return 1 - decayed * (std::cos(b) + c * slope);
  return slow_spring(c, c) + decayed * (2 * half * half + c * (1 - slope));
}

// 1 - e^-c (cosh b + c sinh b / b), by its slower exponent, c - b.
double creeping_spring(double slower, double b) {
  const double part = b > 0 ? one_less_exp(2 * b) / (2 * b) : 1;
  if (slower >= 1) return 1 - std::exp(-slower) * (1 + slower * part);
  return one_less_exp(slower) - std::exp(-slower) * slower * part;
}

}  // namespace

// x'' = w^2 (1 - x) - 2 z w x', by s = w t. Its exponents are s (z +- root(z^2 - 1)); their product is s^2.
double spring(double t, double cycles, double damping) {
  const double s = 2 * pi * cycles * t, root = std::sqrt(std::abs((1 - damping) * (1 + damping)));
  const double faster = damping > 1 ? s * (damping + root) : s;
  if (faster <= 1) return slow_spring(s, damping * s);
  return damping < 1 ? swinging_spring(damping * s, root * s)
                     : creeping_spring(s / (damping + root), root * s);
}

}  // namespace first_contact::ease::formula
