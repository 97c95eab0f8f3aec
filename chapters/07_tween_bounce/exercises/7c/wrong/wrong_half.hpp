// Looks like: the wrong half is kept: the search runs to the beginning or to the end.
// Ask: in the middle the ball is still above the floor. In which half does it touch?
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  if (to > r) return {};
  double before = 0, after = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (before + after) / 2;
    (from + ease(easing, middle) * (to - from) > r ? after : before) = middle;
  }
  return after;
}
