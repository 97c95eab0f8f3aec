// Looks like: the first of sixty pictures in which the ball is found in the floor: late by up to a sixtieth.
// Ask: in this picture it overlaps already. When did it touch?
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  for (int i = 0; i <= 60; ++i)
    if (from + ease(easing, i / 60.0) * (to - from) <= r) return i / 60.0;
  return {};
}
