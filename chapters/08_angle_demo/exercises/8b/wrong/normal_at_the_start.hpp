// Looks like: the normal is that at the start: the struck disc goes off at -11.31 degrees where it should at
// -30.
// Ask: the discs have moved since. Along which line do they touch?
// Seen in: the paper, program 4; Construct (Scirra/Construct-bugs#3447)
#include "task.hpp"

Discs step(const Discs& discs) {
  Discs after = discs;
  auto& [a, b] = after;
  const auto t = meeting(a, b);
  if (!t || *t > 1)
    return {{a.place + a.velocity, a.velocity, a.mass, a.radius},
            {b.place + b.velocity, b.velocity, b.mass, b.radius}};
  const Vector2 N = a.place - b.place;
  a.place = a.place + *t * a.velocity, b.place = b.place + *t * b.velocity;
  collide(a, b, N);
  a.place = a.place + (1 - *t) * a.velocity, b.place = b.place + (1 - *t) * b.velocity;
  return after;
}
