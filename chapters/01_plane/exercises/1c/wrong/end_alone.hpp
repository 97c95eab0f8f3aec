// Looks like: only the end of the motion is looked at.
// Ask: a fast ball is above the floor in one picture and below it in the next. When did it pass through?
// Seen in: TombEngine (TombEngine/TombEngine#163)
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) {
  return dot(E, S1) > r || (dot(E, S1) < -r && r >= 0 && norm(S0) >= 0);
}
