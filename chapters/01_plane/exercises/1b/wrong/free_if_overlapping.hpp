// Looks like: a ball that overlaps at the start has no contact, whatever it does.
// Ask: a ball lies a hair too deep in the floor and falls on. Who stops it?
#include "task.hpp"

std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) {
  const double side = dot(E, S0) < 0 ? -1 : 1, height = side * dot(E, S0), toward = side * dot(E.N, V);
  if (height < r || toward >= 0) return {};
  const double t = (r - height) / toward;
  if (t > 1) return {};
  return t;
}
