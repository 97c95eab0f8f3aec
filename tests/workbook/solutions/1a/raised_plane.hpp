#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const Plane raised{E.N, E.D - r * norm(E.N)};
  const double gap = dot(raised, S0), toward = dot(E.N, V);
  if (toward >= 0) return {};
  const double t = -gap / toward;
  if (t > 1) return {};
  return t;
}
