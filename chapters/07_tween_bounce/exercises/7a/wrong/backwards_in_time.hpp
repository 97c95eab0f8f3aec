// Looks like: out is in(1 - s): the film runs backwards, from 1 to 0.
// Ask: where is the thing at the beginning? What is still to be turned round?
#include "task.hpp"

Eased ease(double s, double p) {
  return {in(1 - s, p), s < 0.5 ? in(2 * s, p) / 2 : 1 - in(2 - 2 * s, p) / 2};
}
