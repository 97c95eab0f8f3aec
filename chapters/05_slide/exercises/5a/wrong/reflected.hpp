// Looks like: the motion is reflected, not projected: twice the part along N is taken.
// Ask: does a ball that slides come back from the wall?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) >= 0) return w;
  return w - 2 * dot(w, N) / dot(N, N) * N;
}
