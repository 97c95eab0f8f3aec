#include "task.hpp"

// How far along V the ball may go, 0 to 1, and still keep the gap between itself and the wall.
double stop_time(Plane E, Point S0, Vector V, double r, double gap) { return {}; }
