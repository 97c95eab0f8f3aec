#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  Vector lowest{0, 0, 0};
  for (const Vector& axis : {box.R, box.S, box.T})
    lowest = dot(axis, N) > 0 ? lowest - 0.5 * axis : lowest + 0.5 * axis;
  return -dot(lowest, N);
}
