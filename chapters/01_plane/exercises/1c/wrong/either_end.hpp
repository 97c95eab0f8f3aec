// Looks like: one free end is enough.
// Ask: it begins in the floor and ends above it. Did it touch the floor?
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) {
  return (dot(E, S0) > r || dot(E, S1) > r) || (dot(E, S0) < -r || dot(E, S1) < -r);
}
