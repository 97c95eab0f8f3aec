// Looks like: always along the crease, also where one wall would do, or none.
// Ask: the ball flies away from both walls. Must it follow the crease?
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  const Vector c = cross(N, M) / norm(cross(N, M));
  return dot(w, c) * c;
}
