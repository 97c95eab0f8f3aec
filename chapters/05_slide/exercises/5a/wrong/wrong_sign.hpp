// Looks like: the part along N is added, not taken away: the ball goes into the wall twice as far.
// Ask: w.N is negative. Is -(w.N) N toward the wall or away from it?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) >= 0) return w;
  return w + dot(w, N) / dot(N, N) * N;
}
