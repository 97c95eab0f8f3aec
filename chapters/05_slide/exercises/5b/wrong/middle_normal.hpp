// Looks like: the two walls are made one, with the sum of the normals.
// Ask: in a right-angled corner, does the middle normal keep the ball out of both walls?
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  const Vector n = (N + M) / norm(N + M);
  return w - std::min(0.0, dot(w, n)) * n;
}
