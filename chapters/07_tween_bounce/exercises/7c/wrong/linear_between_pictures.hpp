// Looks like: between the two pictures around the contact the ball is taken to move evenly: nearly right, and
// not to a thousand millionth.
// Ask: how much does the speed change from one picture to the next?
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  const auto height = [&](double time) { return from + ease(easing, time) * (to - from) - r; };
  for (int i = 1; i <= 60; ++i)
    if (height(i / 60.0) <= 0)
      return (i - 1 + height((i - 1) / 60.0) / (height((i - 1) / 60.0) - height(i / 60.0))) / 60;
  return {};
}
