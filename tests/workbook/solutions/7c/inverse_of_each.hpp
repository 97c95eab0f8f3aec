#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  if (to > r) return {};
  const double u = (from - r) / (from - to);
  switch (easing) {
    case Easing::in:
      return std::cbrt(u);
    case Easing::out:
      return 1 - std::cbrt(1 - u);
    case Easing::in_out:
      break;
  }
  double s = 0.5;  // Newton's method, kept between 0 and 1
  for (int i = 0; i < 100; ++i)
    s = std::clamp(s - (ease(easing, s) - u) / std::max(1e-3, 6 * s * (1 - s)), 0.0, 1.0);
  return s;
}
