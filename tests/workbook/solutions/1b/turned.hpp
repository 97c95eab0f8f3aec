#include "task.hpp"

std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) {
  if (dot(E, S0) < 0) E = {-E.N, -E.D};
  const double before = dot(E, S0), after = dot(E, S0 + V);
  if (after >= before) return {};
  if (before <= r) return 0.0;
  if (after <= r) return (before - r) / (before - after);
  return {};
}
