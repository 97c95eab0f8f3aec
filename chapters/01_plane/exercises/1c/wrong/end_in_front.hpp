// Looks like: only the end is looked at, and only in front of the plane.
// Ask: what of the beginning? And is a ball that is wholly below the floor not free?
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) { return dot(E, S1) > r && norm(S0) >= 0; }
