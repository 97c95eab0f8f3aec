#include "first_contact/motion/easing_formula.hpp"

#include <cmath>
#include <numbers>

namespace first_contact::ease::formula {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

double exponential(double t, double b) {
  return std::expm1(b * std::numbers::ln2 * t) / (b == 10 ? 1023 : std::expm1(b * std::numbers::ln2));
}

double back(double t, double overshoot) { return t * t * (t - overshoot * (1 - t)); }

double elastic(double t, double amplitude, double period) {
  const double turn = 20 * pi / 3 * (0.3 / period) * (1 - t);  // 2 pi / 0.3 is 20 pi / 3
  return amplitude * exponential(t) * std::cos(turn - std::acos(1 / amplitude));
}

// 1 - e^(-z w t) (cos v t + z w / v sin v t) with v = w root(1 - z^2), and what becomes of it at and above z = 1.
double spring(double t, double cycles, double damping) {
  const double w = 2 * pi * cycles, decay = damping * w, spread = (1 - damping) * (1 + damping);
  if (spread > 0) {
    const double v = w * std::sqrt(spread);
    return 1 - std::exp(-decay * t) * (std::cos(v * t) + decay / v * std::sin(v * t));
  }
  if (spread == 0) return 1 - std::exp(-w * t) * (1 + w * t);
  const double v = w * std::sqrt(-spread);  // by two exponentials, as cosh and sinh would overflow
  const double slow = std::exp(-w * w / (decay + v) * t), fast = std::exp(-(decay + v) * t);
  return 1 - (slow + fast) / 2 - decay / v * (slow - fast) / 2;
}

}  // namespace first_contact::ease::formula
