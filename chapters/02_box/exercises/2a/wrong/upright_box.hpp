// Looks like: the axes are taken for those of the room: R is x, S is y, T is z.
// Ask: what is N.x to a box that is turned?
#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  return 0.5 * (norm(box.R) * std::abs(N.x) + norm(box.S) * std::abs(N.y) + norm(box.T) * std::abs(N.z));
}
