#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) {
  const double begin = dot(E, S0), end = dot(E, S1);
  return begin * end > 0 && std::min(std::abs(begin), std::abs(end)) > r;
}
