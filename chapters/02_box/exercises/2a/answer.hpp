#include "task.hpp"

// How far the box reaches from its centre Q along N, which has length 1: half of its height as seen from a
// plane.
double effective_radius(const Box& box, Vector N) { return {}; }
