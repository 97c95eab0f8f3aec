// Looks like: the wall into which it leads most is taken first, and then again, until it leads into none: in
// a wide crease it ends beside the nearest, in a sharp one it comes to it too slowly.
// Ask: is what is left along the worst wall always the nearest? Compare the lengths of your candidates.
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  Vector v = w;
  for (int i = 0; i < 4; ++i) {
    const double into_n = dot(v, N), into_m = dot(v, M);
    if (into_n >= 0 && into_m >= 0) return v;
    v = into_n < into_m ? v - into_n * N : v - into_m * M;
  }
  return v;
}
