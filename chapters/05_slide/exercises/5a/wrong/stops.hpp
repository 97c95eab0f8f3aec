// Looks like: a motion into the wall ends there: nothing of it is kept.
// Ask: what of the part that leads along the wall?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) >= 0) return w;
  return {};
}
