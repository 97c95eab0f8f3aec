// Looks like: E.S is taken for the distance of S, whatever the length of N.
// Ask: what is E.S for a point one above the floor, if N = (0, 0, 2)? At which height does your ball stop
// then?
// Seen in: Bevy (bevyengine/bevy#3744); Computer Graphics from Scratch
// (ggambetta/computer-graphics-from-scratch, PR 10)
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  const double t = (r - dot(E, S0)) / dot(E.N, V);
  if (!(t >= 0 && t <= 1)) return {};
  return t;
}
