#include "first_contact/sweep/ray_triangle.hpp"

#include "catch.hpp"
#include "first_contact/geometry/line_triangle.hpp"

using namespace first_contact;

namespace {

const Triangle tile{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

std::optional<Contact> shoot(const Point& from, const Point& to) {
  return sweep(Moving<Point>{from, to - from}, tile);
}

}  // namespace

TEST_CASE("A ray meets a triangle where it meets its plane, if that is inside") {
  const auto contact = shoot({0, 0, 2}, {2, 2, -2});
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->point() == Point(1, 1, 0));
  CHECK(contact->normal == Vector(0, 0, 1));
  CHECK(contact->feature == Feature::face);
}
TEST_CASE("A ray beside a triangle, away from it, or too short does not meet it") {
  CHECK_FALSE(shoot({3, 3, 2}, {3, 3, -2}));
  CHECK_FALSE(shoot({1, 1, 2}, {1, 1, 4}));
  CHECK_FALSE(shoot({1, 1, 2}, {1, 1, 0.5}));
}
TEST_CASE("A triangle has two sides for a ray: from below, the normal points down") {
  CHECK(shoot({1, 1, -2}, {1, 1, 2})->normal == Vector(0, 0, -1));
}
TEST_CASE("A ray through an edge or a vertex of a triangle meets it") {
  CHECK(shoot({2, 0, 2}, {2, 0, -2})->time == 0.5);
  CHECK(shoot({2, 2, 2}, {2, 2, -2})->time == 0.5);
  CHECK(shoot({0, 4, 2}, {0, 4, -2})->time == 0.5);
}
TEST_CASE("A ray within the plane of a triangle meets its edge") {
  const auto contact = shoot({1, -2, 0}, {1, 2, 0});
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->normal == Vector(0, -1, 0));
  CHECK(contact->feature == Feature::edge);
}
TEST_CASE("A ray that starts on a triangle has a contact at once, its normal against the ray") {
  CHECK(shoot({1, 1, 0}, {1, 1, 5})->time == 0);
  CHECK(shoot({1, 1, 0}, {1, 1, 5})->normal == Vector(0, 0, -1));
  CHECK_FALSE(shoot({1, 1, 0}, {2, 1, 0}));  // sliding within the face
}
TEST_CASE(
    "The weights of a line and a triangle are not negative, have the sum 1, and give the point they meet "
    "in") {
  const auto weights = weights_where_line_meets({0, 0, 2}, {2, 2, -4}, tile);
  REQUIRE(weights);
  CHECK(*weights == Vector(0.5, 0.25, 0.25));
}
TEST_CASE("A line meets a triangle behind its point, too, but not a triangle in whose plane it lies") {
  CHECK(weights_where_line_meets({1, 1, 5}, {0, 0, 1}, tile));
  CHECK_FALSE(weights_where_line_meets({1, 1, 0}, {1, 0, 0}, tile));
  CHECK_FALSE(weights_where_line_meets({1, 1, 0}, {0, 0, 0}, tile));
}
