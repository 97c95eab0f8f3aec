// Looks like: three pictures are looked at, the beginning, the middle and the end; it tunnels all the same,
// only less often.
// Ask: how many pictures would be enough for every speed?
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) {
  for (const double t : {0.0, 0.5, 1.0})
    if (std::abs(dot(E, S0 + t * (S1 - S0))) <= r) return false;
  return true;
}
