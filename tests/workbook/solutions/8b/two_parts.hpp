#include "task.hpp"

Discs step(const Discs& discs) {
  Discs after = discs;
  auto& [a, b] = after;
  const auto t = meeting(a, b);
  const double first = t && *t <= 1 ? *t : 1;
  a.place = a.place + first * a.velocity, b.place = b.place + first * b.velocity;
  if (t && *t <= 1) collide(a, b, a.place - b.place);
  a.place = a.place + (1 - first) * a.velocity, b.place = b.place + (1 - first) * b.velocity;
  return after;
}
