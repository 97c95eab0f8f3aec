// Looks like: whatever approaches is turned, with the normal at the start, as the paper's program does it.
// Ask: two ships approach each other. Must they meet?
// Seen in: the paper, program 4
#include "task.hpp"

Discs step(const Discs& discs) {
  Discs after = discs;
  auto& [a, b] = after;
  if (dot(a.velocity - b.velocity, a.place - b.place) < 0) collide(a, b, a.place - b.place);
  a.place = a.place + a.velocity, b.place = b.place + b.velocity;
  return after;
}
