#include "task.hpp"

// The t in [0, 1] at which a ball first touches the line through a and b, if it does so between a and b; else
// {}.
std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) { return {}; }
