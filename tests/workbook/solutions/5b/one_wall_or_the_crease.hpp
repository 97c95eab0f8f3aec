#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  if (dot(w, N) >= 0 && dot(w, M) >= 0) return w;
  const Vector v1 = w - dot(w, N) * N, v2 = w - dot(w, M) * M;
  const bool one = dot(w, N) < 0 && dot(v1, M) >= 0, other = dot(w, M) < 0 && dot(v2, N) >= 0;
  if (one && (!other || dot(v1, v1) > dot(v2, v2))) return v1;
  if (other) return v2;
  const Vector c = cross(N, M);
  return dot(w, c) / dot(c, c) * c;
}
