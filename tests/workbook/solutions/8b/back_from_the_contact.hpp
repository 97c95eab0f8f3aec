#include "task.hpp"

static Disc moved(Disc disc, double t) {
  disc.place = disc.place + t * disc.velocity;
  return disc;
}

Discs step(const Discs& discs) {
  const auto t = meeting(discs.first, discs.second);
  if (t.value_or(2) > 1) return {moved(discs.first, 1), moved(discs.second, 1)};
  Disc a = moved(discs.first, *t), b = moved(discs.second, *t);
  collide(a, b, (a.place - b.place) / (a.radius + b.radius));
  return {moved(a, 1 - *t), moved(b, 1 - *t)};
}
