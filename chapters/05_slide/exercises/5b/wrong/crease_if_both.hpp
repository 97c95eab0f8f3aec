// Looks like: along the crease whenever w leads into both walls. In a wide crease it is nearer to follow one
// wall, away from the other.
// Ask: two walls make a wide, flat valley. Is what is left along the one always into the other?
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  const bool into_n = dot(w, N) < 0, into_m = dot(w, M) < 0;
  const Vector c = cross(N, M) / norm(cross(N, M));
  if (into_n && into_m) return dot(w, c) * c;
  if (into_n) {
    const Vector v = w - dot(w, N) * N;
    return dot(v, M) < -1e-9 ? dot(w, c) * c : v;
  }
  if (into_m) {
    const Vector v = w - dot(w, M) * M;
    return dot(v, N) < -1e-9 ? dot(w, c) * c : v;
  }
  return w;
}
