#include "first_contact/sweep/sphere_plane.hpp"

#include <cmath>

#include "catch.hpp"

using namespace first_contact;

namespace {

const Plane floor_plane{{0, 0, 2}, 0};  // not of unit length on purpose

std::optional<Contact> drop(double from, double to, double radius = 1) {
  return sweep(Moving<Sphere>{{{0, 0, from}, radius}, {0, 0, to - from}}, floor_plane);
}

}  // namespace

TEST_CASE("A sphere meets a plane when its centre is one radius away") {
  const auto contact = drop(3, -1);
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->point() == Point(0, 0, 0));
  CHECK(contact->normal == Vector(0, 0, 1));
  CHECK(contact->feature == Feature::face);
}

TEST_CASE("A sphere that ends short of the plane does not meet it") { CHECK_FALSE(drop(3, 1.25)); }
TEST_CASE("A sphere that arrives exactly at the end of its motion meets the plane at t = 1") {
  CHECK(drop(3, 1)->time == 1);
}
TEST_CASE("A sphere touching a plane and leaving has no contact") { CHECK_FALSE(drop(1, 2)); }
TEST_CASE("A sphere touching a plane and approaching has a contact at once") { CHECK(drop(1, 0)->time == 0); }
TEST_CASE("A sphere touching a plane and sliding along has no contact") {
  CHECK_FALSE(sweep(Moving<Sphere>{{{0, 0, 1}, 1}, {5, 0, 0}}, floor_plane));
}
TEST_CASE("A sphere overlapping a plane and going deeper has a contact at once") {
  CHECK(drop(0.5, 0)->time == 0);
}
TEST_CASE("A sphere overlapping a plane and leaving has no contact, so that it can get out") {
  CHECK_FALSE(drop(0.5, 2));
}
TEST_CASE("A sphere at rest has no contact, overlapping or not") {
  CHECK_FALSE(drop(0.5, 0.5));
  CHECK_FALSE(drop(1, 1));
}
TEST_CASE("A plane has two sides: from below, the normal points down") {
  CHECK(drop(-3, 1)->normal == Vector(0, 0, -1));
}
TEST_CASE("A centre on the plane has its normal against the motion") {
  CHECK(drop(0, -1)->normal == Vector(0, 0, 1));
  CHECK(drop(0, 1)->normal == Vector(0, 0, -1));
  CHECK(drop(0, 1)->time == 0);
}
TEST_CASE("A sphere of radius 0 is a point") { CHECK(drop(1, -1, 0)->time == 0.5); }
TEST_CASE("Sphere and plane overlap from touching on, on both sides") {
  CHECK(overlap(Sphere{{7, 0, 1}, 1}, floor_plane));
  CHECK(overlap(Sphere{{7, 0, -0.5}, 1}, floor_plane));
  CHECK_FALSE(overlap(Sphere{{7, 0, -1.5}, 1}, floor_plane));
}
TEST_CASE("The point of an overlapping sphere is on the plane: the foot of its centre") {
  CHECK(drop(0.5, 0)->point() == Point(0, 0, 0));
  CHECK(drop(-0.25, 0)->point() == Point(0, 0, 0));
  CHECK(drop(0, 1)->point() == Point(0, 0, 0));
}
TEST_CASE("A sphere and a plane scaled by a power of two give the bitwise scaled answer") {
  const Vector n{1, -2, 0.3}, v{-4, 5, 1};
  const Sphere sphere{{3, -1, 2}, 0.7};
  const auto here = sweep(Moving{sphere, v}, Plane(n, 0.1));
  REQUIRE(here);
  for (const int power : {-500, -40, 3, 500}) {
    const double scale = std::ldexp(1.0, power);
    const Sphere scaled{scale * sphere.center, scale * sphere.radius};
    const auto there = sweep(Moving{scaled, Vector(scale * v)}, Plane(n, scale * 0.1));
    CAPTURE(power);
    REQUIRE(there);
    CHECK(here->time == there->time);
    CHECK(here->normal == there->normal);
    CHECK(scale * here->points == there->points);
  }
}

// Published mistakes of libraries, as numbers: the plane is N.Q = offset. A ray is a moving sphere of radius
// 0.

TEST_CASE(
    "A ray that meets a tilted plane does so: one library took the root of a negative number (ofxRay#18)") {
  const Plane tilted({0.0015, 0.5, -0.866}, 36.80498035);
  const auto contact = sweep(Moving{Sphere{{0, 0, 0}, 0}, {0, 0, 100}}, tilted);
  REQUIRE(contact);
  CHECK(contact->time == Approx(0.424999773094688237).epsilon(1e-15));
  CHECK(contact->normal.isApprox(Vector(0.0015000313134805067, 0.5000104378268356, -0.8660180783160792),
                                 1e-15));
}
TEST_CASE(
    "A ray that leaves a plane does not meet it: one library said at distance 0 (sharpdx/SharpDX#438)") {
  const Plane plane({0, 0.7071067690849304, 0.7071067690849304}, -3.535533905029297);
  const Sphere point{{6.666666507720947, 3.3333332538604736, 3.3333332538604736}, 0};
  CHECK_FALSE(sweep(Moving{point, {-0.4999999701976776, 0.4999999701976776, 0.4999999701976776}}, plane));
}
