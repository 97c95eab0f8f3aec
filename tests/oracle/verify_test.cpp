// A slice of what ./course verify does a million times.
#include <array>

#include "catch.hpp"
#include "verify/judge.hpp"
#include "verify/surfaces.hpp"

TEST_CASE("A sphere swept against any surface misses nothing, sees no ghosts, and comes in time, within the bound") {
  const int kind = GENERATE(range(0, surfaces::kinds));
  CAPTURE(surfaces::name(kind));
  std::array<judge::Tally, surfaces::aims> tallies{};
  for (std::uint64_t seed = 1; seed <= 8; ++seed) judge::verify(seed, kind, 60, tallies.data());
  for (const judge::Tally& tally : tallies) {
    CHECK(tally.missed == 0);
    CHECK(tally.false_hits == 0);
    CHECK(tally.inexact == 0);
    CHECK(tally.unlike == 0);
  }
}
