// Looks like: a gap is kept only if the motion would lead into the wall; if it ends within the gap, the ball
// is let go.
// Ask: the motion ends a hair above the wall. How large is the gap then?
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V);
  if (toward >= 0 || dot(E, S0) + toward > r) return 1;
  return std::clamp((r + gap - dot(E, S0)) / toward, 0.0, 1.0);
}
