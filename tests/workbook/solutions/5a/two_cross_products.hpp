#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) > 0) return w;
  return cross(N, cross(w, N)) / dot(N, N);
}
