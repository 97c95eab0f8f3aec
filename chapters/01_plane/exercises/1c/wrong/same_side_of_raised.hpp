// Looks like: both centres are on one side of the *raised* plane: also two that are both deep in the plane,
// or a ball below it that comes near.
// Ask: both products are negative. Where can the centres be then? A plane has two sides, and two raised
// planes.
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) { return (dot(E, S0) - r) * (dot(E, S1) - r) > 0; }
