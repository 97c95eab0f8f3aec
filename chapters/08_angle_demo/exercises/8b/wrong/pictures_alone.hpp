// Looks like: first both move for the whole step; if they overlap then, they are turned: too late, too deep,
// and along another normal.
// Ask: where were they when they touched?
// Seen in: Scirra/Construct-bugs#3447
#include "task.hpp"

Discs step(const Discs& discs) {
  Discs after = discs;
  auto& [a, b] = after;
  a.place = a.place + a.velocity, b.place = b.place + b.velocity;
  if (norm(a.place - b.place) < a.radius + b.radius && dot(a.velocity - b.velocity, a.place - b.place) < 0)
    collide(a, b, a.place - b.place);
  return after;
}
