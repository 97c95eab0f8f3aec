// Looks like: N is taken to have length 1: (w.N) N is not divided by N.N.
// Ask: with twice the normal, does the ball end elsewhere? How often does N stand in (w.N) N?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) >= 0) return w;
  return w - dot(w, N) * N;
}
