// Looks like: in-out is the mean of in and out: with squares that is even motion, and not slow at all.
// Ask: how fast is the mean at the very beginning?
#include "task.hpp"

Eased ease(double s, double p) { return {1 - in(1 - s, p), (in(s, p) + 1 - in(1 - s, p)) / 2}; }
