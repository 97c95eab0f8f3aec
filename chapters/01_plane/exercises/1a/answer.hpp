#include "task.hpp"

// The time t in [0, 1] at which a ball of radius r, whose centre goes from S0 to S0 + V, touches E; {} if it
// does not.
std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) { return {}; }
