#include "task.hpp"

Eased ease(double s, double p) {
  const double out = 1 - in(1 - s, p);
  return {out, s < 0.5 ? in(2 * s, p) / 2 : 1 - in(2 - 2 * s, p) / 2};
}
