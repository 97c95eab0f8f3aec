// Looks like: along the crease as soon as the motion leads into one of the walls: one wall would do.
// Ask: it leads into the floor and away from the other wall. Why should the other wall hold it?
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  if (dot(w, N) >= 0 && dot(w, M) >= 0) return w;
  const Vector c = cross(N, M) / norm(cross(N, M));
  return dot(w, c) * c;
}
