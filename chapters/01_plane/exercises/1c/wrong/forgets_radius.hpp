// Looks like: the centre does not pass through the plane; but the ball is larger than its centre.
// Ask: the centre ends 1/4 above the floor, and r is 1/2. Is the ball free?
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) { return dot(E, S0) * dot(E, S1) > 0 && r >= 0; }
