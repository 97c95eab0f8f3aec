// Looks like: first along the one wall, then what is left along the other: in a sharp crease that leads into
// the first again, v.N < 0.
// Ask: after the second projection, what is v.N?
// Seen in: the paper's formula used twice; OpenKCC (nicholas-maltbie/OpenKCC#42) and Godot
// (godotengine/godot#32182) showed the jitter
#include "task.hpp"

Vector along_two_walls(Vector w, Vector N, Vector M) {
  Vector v = w;
  if (dot(v, N) < 0) v = v - dot(v, N) * N;
  if (dot(v, M) < 0) v = v - dot(v, M) * M;
  return v;
}
