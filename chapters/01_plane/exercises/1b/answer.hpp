#include "task.hpp"

// The first contact in [0, 1] from either side; 0 if the ball overlaps at the start and goes deeper; else {}.
std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) { return {}; }
