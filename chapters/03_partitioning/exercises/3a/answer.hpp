#include "task.hpp"

// From when to when, within [0, 1], the path S0 + tV is in the box; {} if it never is.
std::optional<Stay> stay_in(const Bounds& box, Point S0, Vector V) { return {}; }
