// Looks like: the second half of in-out is in once more: it stops half way, and rushes into its end.
// Ask: is it slow at the end?
#include "task.hpp"

Eased ease(double s, double p) {
  return {1 - in(1 - s, p), s < 0.5 ? in(2 * s, p) / 2 : 0.5 + in(2 * s - 1, p) / 2};
}
