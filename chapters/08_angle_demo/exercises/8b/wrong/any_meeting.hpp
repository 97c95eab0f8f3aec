// Looks like: a meeting that is still to come, after this step, happens in it already.
// Ask: meeting says 1.5, and the step lasts 1. What happens in this step?
#include "task.hpp"

Discs step(const Discs& discs) {
  Discs after = discs;
  auto& [a, b] = after;
  if (const auto t = meeting(a, b)) {
    a.place = a.place + *t * a.velocity, b.place = b.place + *t * b.velocity;
    collide(a, b, a.place - b.place);
    a.place = a.place + (1 - *t) * a.velocity, b.place = b.place + (1 - *t) * b.velocity;
    return after;
  }
  a.place = a.place + a.velocity, b.place = b.place + b.velocity;
  return after;
}
