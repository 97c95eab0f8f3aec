// Looks like: out is 1 - in(s): it begins at 1 and ends at 0.
// Ask: where is the thing at the beginning?
#include "task.hpp"

Eased ease(double s, double p) {
  return {1 - in(s, p), s < 0.5 ? in(2 * s, p) / 2 : 1 - in(2 - 2 * s, p) / 2};
}
