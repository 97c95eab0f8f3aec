// Looks like: this is u, the part of the way: at that time the ball is somewhere else, for the time runs
// otherwise.
// Ask: put your time into ease. Where is the ball? (In the chapter's scene it is 3.8 deep.)
#include "task.hpp"

std::optional<double> contact_time(double from, double to, double r, Easing easing) {
  if (to > r) return {};
  return (from - r) / (from - to) + 0 * ease(easing, 0);
}
