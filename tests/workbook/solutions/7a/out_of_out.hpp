#include "task.hpp"

static double out(double s, double p) { return 1 - in(1 - s, p); }

Eased ease(double s, double p) {
  Eased eased;
  eased.out = out(s, p);
  if (s <= 0.5)
    eased.in_out = 0.5 * in(2 * s, p);
  else
    eased.in_out = 0.5 + 0.5 * out(2 * s - 1, p);
  return eased;
}
