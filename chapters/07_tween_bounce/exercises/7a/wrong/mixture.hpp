// Looks like: in-out is a mixture of in and out, each with its weight.
// Ask: is it `in` in the first half, at half the size? Compare both at a quarter.
#include "task.hpp"

Eased ease(double s, double p) { return {1 - in(1 - s, p), (1 - s) * in(s, p) + s * (1 - in(1 - s, p))}; }
