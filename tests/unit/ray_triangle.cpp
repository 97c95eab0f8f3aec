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

// Found by ./course verify: the rounding of the cross product had turned the normal along the triangle.
TEST_CASE("A ray through a long and thin triangle hits it") {
  const Triangle thin({602.04801044116209, 218.87750812808028, -266.73390891094459},
                      {263.42768149370244, 312.31685232063819, -323.47214473585933},
                      {429.04806078518362, 266.60026356152775, -295.69824912495829});
  const auto hit = sweep(Moving<Point>{{404.45593038290508, 271.82174490704898, -295.96340636994853},
                                       {12.65642020376484, 1.7311458444456203, -10.726442057929331}},
                         thin);
  REQUIRE(hit);
  CHECK(hit->feature == Feature::face);
  CHECK(hit->time == Approx(0.30107085387007654).epsilon(1e-12));  // by exact fractions
}

// The far corners are rounded coarsely, as seen from the near one.
TEST_CASE("A ray through a large triangle, close to one of its corners, hits it") {
  const Triangle large({9625.3363577164455, -2613.9737799195195, 721.13873749448612},
                       {2245.770793042293, 9175.0748707912644, 3282.4555839329828},
                       {1519.6754738891034, 2997.5226760222999, -9418.3567707319307});
  const auto hit = sweep(Moving<Point>{{2364.6880878404195, 9100.3157567116068, 3150.5643904401272},
                                       {-114.24726821652952, -4.4054179296532725, 86.344581021173184}},
                         large);
  REQUIRE(hit);
  CHECK(hit->time == Approx(0.7805622059580964).epsilon(1e-12));  // by exact fractions
}

TEST_CASE("A ray at a flat angle beside a triangle, in parallel to a side, does not meet it") {
  const Triangle triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  CHECK(sweep(Moving<Point>{{0.5, 0.25, 0.125}, {0, 0.25, -0.25}}, triangle));
  CHECK_FALSE(sweep(Moving<Point>{{-0.5, 0.25, 0.125}, {0, 0.25, -0.25}}, triangle));
  CHECK_FALSE(sweep(Moving<Point>{{0.25, -0.5, 0.125}, {0.25, 0, -0.25}}, triangle));
}

TEST_CASE("A ray that meets a triangle at the flattest of angles is there at the time that it tells") {
  const Triangle triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto contact = sweep(Moving<Point>{{-1, 0.25, 0x1p-40}, {2, 0, -0x1.9p-40}}, triangle);
  REQUIRE(contact);
  CHECK(contact->feature == Feature::face);
  CHECK(contact->time == Approx(0.64));
  CHECK(contact->point().isApprox(Point(0.28, 0.25, 0), 1e-3));
}
