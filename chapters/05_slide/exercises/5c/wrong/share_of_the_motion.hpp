// Looks like: the gap is taken from the time: a share of the motion and not a length.
// Ask: t - g mixes a number without a unit and a length. With twice the velocity, is the gap twice as large?
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V);
  if (toward >= 0) return 1;
  return std::clamp((r - dot(E, S0)) / toward - gap, 0.0, 1.0);
}
