// Looks like: the test is the wrong way round: what leads into the wall stays, what leads away is taken.
// Ask: N points to the ball. Which sign has w.N when the ball goes into the wall?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) <= 0) return w;
  return w - dot(w, N) / dot(N, N) * N;
}
