#include "first_contact/sweep/sphere_plane.hpp"

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
TEST_CASE("A sphere overlapping a plane and going deeper has a contact at once") { CHECK(drop(0.5, 0)->time == 0); }
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
