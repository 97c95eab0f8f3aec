#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V);
  if (toward >= 0) return 1;
  return std::clamp((r + gap - dot(E, S0)) / toward, 0.0, 1.0);
}
