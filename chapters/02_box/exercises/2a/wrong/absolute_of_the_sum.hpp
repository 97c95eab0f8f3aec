// Looks like: the absolute value is taken of the whole sum: one axis downward makes the box smaller.
// Ask: may a, b and c be chosen each for itself, or only all together?
#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  return 0.5 * std::abs(dot(box.R, N) + dot(box.S, N) + dot(box.T, N));
}
