#include "task.hpp"

// What comes of in(s, p) when it is mirrored: slow at the end, and slow at both.
Eased ease(double s, double p) { return {}; }
