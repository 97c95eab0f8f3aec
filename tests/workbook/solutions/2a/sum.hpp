#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  return 0.5 * (std::abs(dot(box.R, N)) + std::abs(dot(box.S, N)) + std::abs(dot(box.T, N)));
}
