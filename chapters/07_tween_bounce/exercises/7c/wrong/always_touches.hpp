// Looks like: there always is a contact: where the ball does not come so far, the end is taken for it.
// Ask: it stops above the floor. What do you answer then?
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  double before = 0, after = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (before + after) / 2;
    (from + ease(easing, middle) * (to - from) > r ? before : after) = middle;
  }
  return after;
}
