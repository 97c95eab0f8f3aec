#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  const double slack = -1e-6 * norm(w);
  const Vector c = cross(N, M) / norm(cross(N, M));
  Vector best{};
  for (const Vector& v : {w, w - dot(w, N) * N, w - dot(w, M) * M, dot(w, c) * c})
    if (dot(v, N) >= slack && dot(v, M) >= slack && dot(v, v) > dot(best, best)) best = v;
  return best;
}
