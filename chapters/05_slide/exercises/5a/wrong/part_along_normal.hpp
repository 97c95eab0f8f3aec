// Looks like: this is the part along N, that is, what should be taken away.
// Ask: your ball goes straight into the wall. What did you want to keep?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) >= 0) return w;
  return dot(w, N) / dot(N, N) * N;
}
