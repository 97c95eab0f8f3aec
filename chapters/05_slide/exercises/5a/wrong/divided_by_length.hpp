// Looks like: it is divided by the length of N once, and N stands in (w.N) N twice.
// Ask: how often does N stand in (w.N) N? By what must it be divided?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) >= 0) return w;
  return w - dot(w, N) / norm(N) * N;
}
