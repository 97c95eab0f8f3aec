// Looks like: the new velocities are used for the whole step, from the places at the start.
// Ask: with which velocity did they come to the place where they touch?
#include "task.hpp"

Discs step(const Discs& discs) {
  Discs after = discs;
  auto& [a, b] = after;
  const auto t = meeting(a, b);
  if (t && *t <= 1) collide(a, b, a.place + *t * a.velocity - b.place - *t * b.velocity);
  a.place = a.place + a.velocity, b.place = b.place + b.velocity;
  return after;
}
