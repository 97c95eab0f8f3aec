// A slice of the walks that ./course verify makes a million frames long.
#include "05_slide/walk.hpp"
#include "catch.hpp"

using namespace first_contact;

TEST_CASE(
    "A ball that slides frame after frame is never too deep, never beyond a wall, never thrown back, and "
    "lies "
    "still where it should") {
  for (const walks::Ground& ground : walks::grounds())
    for (const std::uint64_t seed : {11U, 12U, 13U}) {
      CAPTURE(ground.name.english, seed);
      const walks::Walk walk = walks::walk(ground, 3000, seed);
      CHECK(walk.contacts > 100);
      CHECK(walk.tunnelled == 0);
      CHECK(walk.reversed == 0);
      CHECK(walk.depth <= walks::Walk::limit);
      CHECK(walk.drift <= walks::Walk::drift_limit);
      CHECK(walk.good());
    }
}

TEST_CASE("The measure of a walk sees a ball that is too deep, beyond the surface, or not still") {
  const auto floor = walks::grounds()[3];
  walks::Ground sunk = floor, below = floor, rising = floor;
  sunk.ball.center.z() = 0.29;
  below.ball.center.z() = -1;
  below.pull = [](const Point&) { return Vector(0, 0, 2); };
  rising.pull = [](const Point&) { return Vector(0, 0, 0.001); };
  const auto deep = walks::walk(sunk, 10, 1);
  CHECK(deep.depth > 5e-4);
  CHECK_FALSE(deep.good());
  CHECK(walks::walk(below, 10, 1).tunnelled == 10);
  CHECK(walks::walk(rising, 300, 1).drift > walks::Walk::drift_limit);
  CHECK(walks::walk(floor, 300, 1).good());
}

TEST_CASE("A walk is the same for the same seed") {
  const auto room = walks::grounds()[2];
  CHECK(walks::walk(room, 500, 5).trail == walks::walk(room, 500, 5).trail);
  CHECK(walks::walk(room, 500, 5).trail != walks::walk(room, 500, 6).trail);
}
