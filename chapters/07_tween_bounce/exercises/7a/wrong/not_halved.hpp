// Looks like: the first half of in-out makes the whole way: it jumps at one half.
// Ask: how far has it come at one half of the time?
#include "task.hpp"

Eased ease(double s, double p) { return {1 - in(1 - s, p), s < 0.5 ? in(2 * s, p) : 1 - in(2 - 2 * s, p)}; }
