// Looks like: the formula of the second half is used in the first half, too. `1/2` is 0 in C++, where a
// whole number divided by a whole number is a whole number.
// Ask: which of the two formulas is used at s = 0.25, and what is it compared with?
#include "task.hpp"

Eased ease(double s, double p) { return {1 - in(1 - s, p), 1 - in(2 - 2 * s, p) / 2}; }
