#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double way = norm(V), sine = way > 0 ? -dot(E.N, V) / way : 0;
  if (sine <= 0) return 1;
  const double to_the_wall = (dot(E, S0) - r) / sine;
  return std::min(1.0, std::max(0.0, to_the_wall - gap / sine) / way);
}
