// Looks like: after the impact they go on with the velocities that they had before it; the new ones begin in
// the next step.
// Ask: with which velocity does a disc move in the rest of the step?
#include "task.hpp"

Discs step(const Discs& discs) {
  Discs after = discs;
  auto& [a, b] = after;
  const auto t = meeting(a, b);
  a.place = a.place + a.velocity, b.place = b.place + b.velocity;
  if (t && *t <= 1) collide(a, b, a.place - (1 - *t) * a.velocity - b.place + (1 - *t) * b.velocity);
  return after;
}
