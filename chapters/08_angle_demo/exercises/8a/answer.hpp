#include "task.hpp"

// The velocities after the impact of two bodies that touch. N leads from the second to the first, of any
// length.
Velocities impact(const Body& first, const Body& second, Vector2 N, double e) { return {}; }
