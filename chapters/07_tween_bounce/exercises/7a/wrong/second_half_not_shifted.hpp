// Looks like: in the second half of in-out the time is doubled, but not counted from one half on.
// Ask: the second half must take `out` from 0 to 1 while s goes from one half to 1. With which argument?
#include "task.hpp"

Eased ease(double s, double p) {
  return {1 - in(1 - s, p), s < 0.5 ? in(2 * s, p) / 2 : 0.5 + (1 - in(1 - 2 * s, p)) / 2};
}
