// A slice of what ./course verify does a million times.
#include <array>

#include "catch.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "verify/judge.hpp"
#include "verify/surfaces.hpp"

using namespace first_contact;

TEST_CASE(
    "A sphere swept against any surface misses nothing, sees no ghosts, and is in time, within the bound") {
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

TEST_CASE("A point or a small sphere is not lost at a flat angle to a face, nor at a sliver") {
  surfaces::Random random(20);
  judge::Tally tally;
  for (int i = 0; i < 6000; ++i) {
    const Mesh sliver = surfaces::placed(surfaces::sliver(random), random);
    const Moving<Sphere> moving = surfaces::cast(sliver, surfaces::flat, random);
    INFO("cast " << i);
    judge::add(tally, sliver, moving, sweep(moving, sliver.triangle(0)));
    REQUIRE(tally.good());
  }
  CHECK(tally.hits > 3000);
}

TEST_CASE("The judge finds fault with a contact that is left out, made up, or moved by a few bounds") {
  const Mesh floor({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Moving<Sphere> down{Sphere{{0.1, 0.2, 2}, 1}, {0.5, 0, -2}},
      along{Sphere{{0.1, 0.2, 2}, 1}, {2, 0, -0.9}};
  const auto contact = sweep(down, Bvh(floor));
  REQUIRE(contact);
  const auto tally_of = [&](const Moving<Sphere>& moving, const std::optional<Contact>& answer) {
    judge::Tally tally;
    judge::add(tally, floor, moving, answer);
    return tally;
  };
  CHECK(tally_of(down, contact).good());
  CHECK(tally_of(along, std::nullopt).good());
  CHECK(tally_of(down, std::nullopt).missed == 1);
  CHECK(tally_of(along, contact).false_hits == 1);
  Contact early = *contact, late = *contact;
  early.time -= 1e-13;
  late.time += 1e-13;
  CHECK(tally_of(down, early).inexact == 1);
  CHECK(tally_of(down, late).inexact == 1);
}

TEST_CASE("The judge finds fault with the time of a graze at which the sphere is not there") {
  const Mesh small({{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}});
  const Moving<Sphere> over{Sphere{{-3, 0.01, 1 + 1e-15}, 1}, {6, 0, 0}};
  const auto tally_at = [&](double time) {
    judge::Tally tally;
    judge::add(tally, small, over, Contact{time, only(Point::Zero()), Vector::UnitZ(), Feature::face, 0});
    return tally;
  };
  CHECK(tally_at(0.505).good());
  CHECK(tally_at(0.9).inexact == 1);
  CHECK(tally_at(0.9).worst > 1);
}

TEST_CASE("The judge finds fault with a ray that slips through a face, or between two") {
  const Mesh floor({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const auto missed = [&](const Point& from) {
    judge::Tally tally;
    judge::add(tally, floor, {Sphere{from, 0}, {0, 0, -2}}, std::nullopt);
    return tally.missed;
  };
  CHECK(missed({3, 1, 1}) == 1);
  CHECK(missed({1, 1, 1}) == 1);  // on the seam of both
  CHECK(missed({1, 1 + 1e-16, 1}) == 1);
  CHECK(missed({9 - 1e-15, 0, 1}) == 0);  // within the bound of the rim
  CHECK(missed({9.5, 0, 1}) == 0);
  CHECK(missed({3, 1, 2 + 1e-15}) == 0);  // ends before it
}
