// Looks like: only the axis that rises most counts.
// Ask: which point is lower, the middle of the lowest face, or a corner of it?
#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  return 0.5 * std::max({std::abs(dot(box.R, N)), std::abs(dot(box.S, N)), std::abs(dot(box.T, N))});
}
