// Looks like: in-out is fast at both ends and slow in the middle: out-in.
// Ask: which of the two does the first half need?
#include "task.hpp"

Eased ease(double s, double p) {
  return {1 - in(1 - s, p), s < 0.5 ? (1 - in(1 - 2 * s, p)) / 2 : 0.5 + in(2 * s - 1, p) / 2};
}
