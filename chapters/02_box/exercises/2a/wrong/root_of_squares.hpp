// Looks like: the three heights are added like the sides of a right angle, as the root of the sum of squares:
// that is an ellipsoid.
// Ask: climb from the lowest corner to the highest along three edges. How do you add what you have climbed?
#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  return 0.5 * std::hypot(dot(box.R, N), dot(box.S, N), dot(box.T, N));
}
