// Looks like: u is eased once more: f(u) instead of the s with f(s) = u.
// Ask: f makes a part of the way from a part of the time. Which of the two do you have, and which do you
// want?
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  if (to > r) return {};
  return ease(easing, (from - r) / (from - to));
}
