// Looks like: the three products are added with their signs: it is right while R.N, S.N and T.N are all
// positive.
// Ask: R and -R are the same axis of the same box. Does your radius know?
#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  return 0.5 * (dot(box.R, N) + dot(box.S, N) + dot(box.T, N));
}
