// Looks like: it is halved ten times: the time is known to a thousandth only.
// Ask: each halving brings one bit. How many does a thousand millionth need?
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  if (to > r) return {};
  double before = 0, after = 1;
  for (int i = 0; i < 10; ++i) {
    const double middle = (before + after) / 2;
    (from + ease(easing, middle) * (to - from) > r ? before : after) = middle;
  }
  return (before + after) / 2;
}
