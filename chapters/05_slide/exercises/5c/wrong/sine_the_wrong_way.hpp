// Looks like: the gap along the path is g times the sine, where it should be g divided by it.
// Ask: the flatter the ball comes in, the longer or the shorter is the way back that makes a gap of g?
#include "task.hpp"

double stop_time(Plane E, Point S0, Vector V, double r, double gap) {
  const double toward = dot(E.N, V), way = norm(V);
  if (toward >= 0) return 1;
  return std::clamp((r - dot(E, S0)) / toward - gap * (-toward / way) / way, 0.0, 1.0);
}
