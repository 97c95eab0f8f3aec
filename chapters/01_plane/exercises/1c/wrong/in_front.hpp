// Looks like: free means in front of the plane; a ball that stays behind it is said to touch.
// Ask: a ball is under the table and stays there. Does it touch the table?
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) { return dot(E, S0) > r && dot(E, S1) > r; }
