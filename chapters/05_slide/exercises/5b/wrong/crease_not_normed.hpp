// Looks like: N x M is taken as a direction of length 1: it is shorter unless the walls are at right angles.
// Ask: how long is the cross product of two unit vectors at 30 degrees?
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  const double slack = -1e-9;
  if (dot(w, N) >= 0 && dot(w, M) >= 0) return w;
  Vector best = dot(w, cross(N, M)) * cross(N, M);
  double longest = -1;
  for (const Vector& each : {N, M}) {
    const Vector v = w - dot(w, each) * each;
    if (dot(w, each) < 0 && dot(v, N) >= slack && dot(v, M) >= slack && dot(v, v) > longest)
      best = v, longest = dot(v, v);
  }
  return best;
}
