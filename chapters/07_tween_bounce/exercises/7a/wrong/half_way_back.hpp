// Looks like: the second half of in-out does not begin where the first one ends: it jumps at one half.
// Ask: what are both formulas at one half?
#include "task.hpp"

Eased ease(double s, double p) {
  return {1 - in(1 - s, p), s < 0.5 ? in(2 * s, p) / 2 : (1 - in(2 - 2 * s, p)) / 2};
}
