// Looks like: the centre comes to the floor, not the ball's lowest point.
// Ask: how high is the centre when the ball touches?
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  if (to > 0) return {};
  double before = 0, after = 1;
  for (int i = 0; i < 60 && r >= 0; ++i) {
    const double middle = (before + after) / 2;
    (from + ease(easing, middle) * (to - from) > 0 ? before : after) = middle;
  }
  return after;
}
