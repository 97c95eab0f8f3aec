// Looks like: where two walls are in the way the ball stops.
// Ask: a corridor has a floor and a wall. May one not walk along both?
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  if (dot(w, N) >= 0 && dot(w, M) >= 0) return w;
  for (const Vector& each : {N, M}) {
    const Vector v = w - std::min(0.0, dot(w, each)) * each;
    if (dot(v, N) >= -1e-9 && dot(v, M) >= -1e-9) return v;
  }
  return {};
}
