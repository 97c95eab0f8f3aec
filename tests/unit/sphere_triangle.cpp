#include "first_contact/sweep/sphere_triangle.hpp"

#include <limits>

#include "catch.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/sweep/moved_out.hpp"

using namespace first_contact;

namespace {

const Triangle floor_tile{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

std::optional<Contact> cast(const Point& from, const Point& to, double radius = 1,
                            const Triangle& triangle = floor_tile) {
  return sweep(Moving<Sphere>{{from, radius}, to - from}, triangle);
}

}  // namespace

TEST_CASE("A sphere above a triangle meets its face, moved out by the radius") {
  const auto contact = cast({1, 1, 3}, {1, 1, -1});
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->point() == Point(1, 1, 0));
  CHECK(contact->normal == Vector(0, 0, 1));
  CHECK(contact->feature == Feature::face);
}
TEST_CASE("A sphere beside a triangle meets the cylinder about its edge") {
  const auto contact = cast({2, -3, 0}, {2, 1, 0});
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->point() == Point(2, 0, 0));
  CHECK(contact->normal == Vector(0, -1, 0));
  CHECK(contact->feature == Feature::edge);
}
TEST_CASE("A sphere that comes down past an edge meets the cylinder about the original edge") {
  const auto contact = cast({1, -0.6, 3}, {1, -0.6, -1});
  REQUIRE(contact);
  CHECK(contact->time == Approx((3 - 0.8) / 4).epsilon(1e-15));
  CHECK((contact->normal - Vector(0, -0.6, 0.8)).norm() < 1e-15);
  CHECK(contact->feature == Feature::edge);
}
TEST_CASE("A sphere that comes down past a corner meets the sphere about the original vertex") {
  const auto contact = cast({-0.48, -0.36, 3}, {-0.48, -0.36, -1});
  REQUIRE(contact);
  CHECK(contact->time == Approx((3 - 0.8) / 4).epsilon(1e-15));
  CHECK(contact->point() == Point(0, 0, 0));
  CHECK((contact->normal - Vector(-0.48, -0.36, 0.8)).norm() < 1e-15);
  CHECK(contact->feature == Feature::vertex);
}
TEST_CASE("A sphere that only grazes an edge touches it") {
  const auto contact = cast({1, -1, 3}, {1, -1, -1});
  REQUIRE(contact);
  CHECK(contact->time == 0.75);
  CHECK(contact->normal == Vector(0, -1, 0));
}
TEST_CASE("A sphere that passes a triangle does not meet it") {
  CHECK_FALSE(cast({1, -1.001, 3}, {1, -1.001, -3}));
  CHECK_FALSE(cast({5.5, 5.5, 3}, {5.5, 5.5, -3}));
}
TEST_CASE("A sphere that ends short of a triangle does not meet it, and one that ends on it does, at t = 1") {
  CHECK_FALSE(cast({1, 1, 3}, {1, 1, 1.25}));
  CHECK(cast({1, 1, 3}, {1, 1, 1})->time == 1);
  CHECK(cast({1, -3, 0}, {1, -1, 0})->time == 1);
  CHECK(cast({-3, 0, 0}, {-1, 0, 0})->time == 1);
}
TEST_CASE("A triangle has two sides: from below, the normal points down") {
  CHECK(cast({1, 1, -3}, {1, 1, 1})->normal == Vector(0, 0, -1));
}
TEST_CASE(
    "A sphere touching a triangle has a contact at once if it approaches, none if it slides or leaves") {
  CHECK(cast({1, 1, 1}, {1, 1, 0})->time == 0);
  CHECK_FALSE(cast({1, 1, 1}, {1, 1, 2}));
  CHECK_FALSE(cast({1, 1, 1}, {9, 1, 1}));  // off the rim as well
  CHECK(cast({1, -1, 0}, {1, 0, 0})->time == 0);
  CHECK_FALSE(cast({1, -1, 0}, {1, -2, 0}));
  CHECK_FALSE(cast({1, -1, 0}, {-9, -1, 0}));  // along the edge and past the corner
  CHECK(cast({-1, 0, 0}, {0, 0, 0})->time == 0);
  CHECK_FALSE(cast({-1, 0, 0}, {-2, 0, 0}));
  CHECK_FALSE(cast({-1, 0, 0}, {-1, 0, 5}));
}
TEST_CASE("A sphere overlapping a triangle has a contact at once if it goes deeper") {
  const auto contact = cast({1, 1, 0.5}, {1, 1, 0.25});
  REQUIRE(contact);
  CHECK(contact->time == 0);
  CHECK(contact->point() == Point(1, 1, 0));
  CHECK(cast({1, -0.5, 0}, {1, 0, 0})->normal == Vector(0, -1, 0));
  CHECK(cast({-0.5, 0, 0}, {0, 0, 0})->normal == Vector(-1, 0, 0));
}
TEST_CASE("A sphere overlapping a triangle and leaving has no contact, not with the rim on its way either") {
  CHECK_FALSE(cast({1, 1, 0.5}, {1, 1, 3}));
  CHECK_FALSE(cast({1, 1, 0.5}, {1, -9, 0.6}));
  CHECK_FALSE(cast({1, -0.5, 0}, {1, -3, 0}));
}
TEST_CASE("A sphere at rest has no contact with a triangle, overlapping or not") {
  CHECK_FALSE(cast({1, 1, 0.5}, {1, 1, 0.5}));
  CHECK_FALSE(cast({1, 1, 0}, {1, 1, 0}));
  CHECK_FALSE(cast({1, 1, 1}, {1, 1, 1}));
}
TEST_CASE("A centre on the triangle has its normal against the motion") {
  CHECK(cast({1, 1, 0}, {1, 1, -1})->normal == Vector(0, 0, 1));
  CHECK(cast({1, 1, 0}, {1, 1, 1})->normal == Vector(0, 0, -1));
  CHECK(cast({1, 0, 0}, {1, -1, 0})->normal == Vector(0, 1, 0));  // on an edge
  CHECK(cast({0, 0, 0}, {-1, 0, 0})->normal == Vector(1, 0, 0));  // on a vertex
  CHECK_FALSE(cast({1, 1, 0}, {2, 1, 0}));                        // within the face: sliding
}
TEST_CASE("Where a face, an edge and a vertex are met at the same time, it is the face") {
  CHECK(cast({0, 0, 3}, {0, 0, -1})->feature == Feature::face);
  CHECK(cast({2, 0, 3}, {2, 0, -1})->feature == Feature::face);
  CHECK(cast({0, -3, 0}, {0, 1, 0})->feature == Feature::edge);
}
TEST_CASE("To a triangle a sphere of radius 0 is a point") {
  CHECK(cast({1, 1, 1}, {1, 1, -1}, 0)->time == 0.5);
  CHECK(cast({1, -1, 0}, {1, 1, 0}, 0)->feature == Feature::edge);
  CHECK(cast({-1, 0, 0}, {0, 0, 0}, 0)->time == 1);
  CHECK_FALSE(cast({1, -0.001, 1}, {1, -0.001, -1}, 0));
}
TEST_CASE("A triangle that has shrunk to a segment or to a point is one") {
  const Triangle segment{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}}, point{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  CHECK(cast({3, -3, 0}, {3, 1, 0}, 1, segment)->time == 0.5);
  CHECK(cast({3, -3, 0}, {3, 1, 0}, 1, segment)->feature == Feature::edge);
  CHECK(cast({-3, 0, 0}, {1, 0, 0}, 1, segment)->feature == Feature::vertex);
  CHECK(cast({1, 2, 6}, {1, 2, 2}, 1, point)->time == 0.5);
  CHECK(cast({1, 2, 6}, {1, 2, 2}, 1, point)->feature == Feature::vertex);
}
TEST_CASE("Sphere and triangle overlap from touching on, over face, edge and vertex") {
  for (const Point& near : {Point(1, 1, 1), Point(1, -1, 0), Point(-1, 0, 0), Point(1, 1, 0.2)})
    CHECK(overlap(Sphere{near, 1}, floor_tile));
  for (const Point& far : {Point(1, 1, 1.001), Point(1, -1.001, 0), Point(-0.8, -0.8, 0), Point(4, 4, 0)})
    CHECK_FALSE(overlap(Sphere{far, 1}, floor_tile));
  CHECK(overlap(Sphere{{1, 1, 0}, 0}, floor_tile));
}

TEST_CASE("The nearest point of a triangle lies on its face, an edge or a vertex") {
  CHECK(closest_point({1, 1, 5}, floor_tile) == Point(1, 1, 0));
  CHECK(closest_point({2, -3, 1}, floor_tile) == Point(2, 0, 0));
  CHECK(closest_point({-1, -2, 3}, floor_tile) == Point(0, 0, 0));
  CHECK(closest_point({5, 5, 1}, floor_tile) == Point(2, 2, 0));
  CHECK(closest_point({1, 2, 3}, Triangle{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}) == Point(0, 0, 0));
}
TEST_CASE("A face that is flatter than what a ball sags through it is left to its edges") {
  const double height = 1e-9;
  const Facet thin(Triangle{{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}});
  const double largest_radius = height * height / (2 * std::numeric_limits<double>::epsilon());
  CHECK(thin.thin_for(1));
  CHECK(thin.thin_for(1.000001 * largest_radius));
  CHECK_FALSE(thin.thin_for(0.999999 * largest_radius));
  const auto contact = cast({0.5, height / 2, 3}, {0.5, height / 2, -1}, 1, thin.triangle);
  REQUIRE(contact);
  CHECK(contact->time == Approx(0.5).epsilon(1e-15));
}

TEST_CASE(
    "A sphere that passes a vertex by a rounding error more than its radius touches it where it is closest") {
  const Triangle below({0, 0, 0}, {1, 0, -9}, {-1, 1, -9});
  const double eps = std::numeric_limits<double>::epsilon();
  const Moving<Sphere> moving{Sphere{{0, -1e-7, 1 + 8 * eps}, 1}, {0, 4, 0}};
  const auto contact = sweep(moving, below);
  REQUIRE(contact);
  CHECK(contact->time == Approx(0.25e-7).epsilon(1e-6));
  CHECK_FALSE(sweep(Moving<Sphere>{Sphere{{0, -1e-7, 1 + 1e-12}, 1}, {0, 4, 0}}, below));
}
