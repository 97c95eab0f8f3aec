// Looks like: true and false are exchanged: you answer whether it touches.
// Ask: what does the name of the function promise when it says true?
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) {
  const double begin = dot(E, S0), end = dot(E, S1);
  return !((begin > r && end > r) || (begin < -r && end < -r));
}
