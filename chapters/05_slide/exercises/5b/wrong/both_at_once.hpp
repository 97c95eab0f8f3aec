// Looks like: the parts along both normals are taken at once: right for walls at right angles only.
// Ask: what the two normals have in common is taken twice. How large is N.M here?
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  return w - std::min(0.0, dot(w, N)) * N - std::min(0.0, dot(w, M)) * M;
}
