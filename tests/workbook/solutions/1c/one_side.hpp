#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) {
  return (dot(E, S0) > r && dot(E, S1) > r) || (dot(E, S0) < -r && dot(E, S1) < -r);
}
