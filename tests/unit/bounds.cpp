#include "first_contact/geometry/bounds.hpp"

#include <cmath>

#include "catch.hpp"

using namespace first_contact;

namespace {

const Bounds unit_box = bounds_between({0, 0, 0}, {1, 1, 1});

}  // namespace

TEST_CASE("Bounds that turn round or are not finite are refused, with value and rule") {
  CHECK_THROWS_WITH(bounds_between({0, 2, 0}, {1, 1, 1}),
                    "bounds from (0, 2, 0) to (1, 1, 1): low must not be above high");
  CHECK_THROWS_AS(bounds_between({0, 0, 0}, {1, INFINITY, 1}), std::invalid_argument);
  CHECK_THROWS_AS(bounds_between({NAN, 0, 0}, {1, 1, 1}), std::invalid_argument);
}

TEST_CASE("The middle of bounds is there even where the sum of their corners is too large for a double") {
  const Bounds box(Point(0x1p1023, -0x1p1023, 1), Point(0x1.8p1023, -0x1p1023, 3));
  CHECK(middle_of(box) == Point(0x1.4p1023, -0x1p1023, 2));
}

TEST_CASE("Bounds may be flat, or of nothing") {
  CHECK_FALSE(bounds_between({1, 2, 3}, {1, 2, 3}).isEmpty());
  CHECK(Bounds().isEmpty());
  CHECK_FALSE(overlap(Bounds(), unit_box));
  CHECK_FALSE(overlap(Bounds(), Bounds()));
  CHECK_FALSE(passage({0, 0, 0}, {1, 0, 0}, Bounds()));
  CHECK(largest_coordinate(Bounds()) == 0);
}

TEST_CASE("The bounds of a triangle are those of its corners") {
  const Bounds bounds = bounds_of(Triangle{{1, 0, 2}, {0, 3, 1}, {2, 1, -1}});
  CHECK(bounds.min() == Point(0, 0, -1));
  CHECK(bounds.max() == Point(2, 3, 2));
}

TEST_CASE("The bounds of a sphere are exact where the sums are") {
  const Bounds bounds = bounds_of(Sphere{{1, 2, 3}, 0.5}, {0, 4, -4});
  CHECK(bounds.min() == Point(0.5, 1.5, -1.5));
  CHECK(bounds.max() == Point(1.5, 6.5, 3.5));
}

TEST_CASE("Where a sum is rounded, the bounds of a sphere are rounded outwards") {
  const Bounds bounds = bounds_of(Sphere{{1, -1, 0}, 0x1p-60});
  CHECK(bounds.min() == Point(std::nextafter(1, 0), std::nextafter(-1, -2), -0x1p-60));
  CHECK(bounds.max() == Point(std::nextafter(1, 2), std::nextafter(-1, 0), 0x1p-60));
}

TEST_CASE("Boxes that share a side, an edge or a corner overlap, the next number beyond does not") {
  CHECK(overlap(unit_box, bounds_between({1, 0, 0}, {2, 1, 1})));
  CHECK(overlap(unit_box, bounds_between({1, 1, 0}, {2, 2, 1})));
  CHECK(overlap(unit_box, bounds_between({1, 1, 1}, {2, 2, 2})));
  CHECK(overlap(unit_box, bounds_between({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})));
  CHECK_FALSE(overlap(unit_box, bounds_between({std::nextafter(1, 2), 0, 0}, {2, 1, 1})));
}

TEST_CASE("A motion along a side of a box is inside it: 0 times infinity is never computed") {
  // (low - s) * (1 / v) is 0 * inf here, not a number, and comparisons with it lose the hit.
  const auto along = passage({-1, 0, 1}, {4, 0, 0}, unit_box);
  REQUIRE(along);
  CHECK(along->enter == 0.25);
  CHECK(along->leave == 0.5);
  CHECK(passage({-1, 0, 1}, {4, -0.0, -0.0}, unit_box));
  CHECK_FALSE(passage({-1, std::nextafter(0, -1), 1}, {4, 0, 0}, unit_box));
}

TEST_CASE("A point at rest is in a box at all times or at none") {
  CHECK(passage({0.5, 1, 0}, {0, 0, 0}, unit_box)->leave == 1);
  CHECK_FALSE(passage({0.5, 1.5, 0}, {0, 0, 0}, unit_box));
}

TEST_CASE("A motion so slow that its times overflow is judged like one at rest") {
  CHECK(passage({0.5, 0.5, 0.5}, {1e-320, -1e-320, 0}, unit_box)->leave == 1);
  CHECK_FALSE(passage({2, 0.5, 0.5}, {-1e-320, 0, 0}, unit_box));
}

TEST_CASE("A passage is looked for in the given part of the motion only") {
  CHECK(passage({-1, 0.5, 0.5}, {4, 0, 0}, unit_box, {0.3, 1})->enter == 0.3);
  CHECK_FALSE(passage({-1, 0.5, 0.5}, {4, 0, 0}, unit_box, {0, 0.2}));
  CHECK_FALSE(passage({-1, 0.5, 0.5}, {4, 0, 0}, unit_box, {0.6, 1}));
}

TEST_CASE("A triangle whose bounds overlap a box may still pass its corner") {
  const Triangle past{{1.25, 0, 1.25}, {0, 1.75, 1.25}, {1.25, 1.75, 0}};
  CHECK(overlap(bounds_of(past), unit_box));
  CHECK_FALSE(overlap(Triangle{{2.5, 0, 0.5}, {0, 2.5, 0.5}, {2.5, 2.5, 0.5}}, unit_box));
  CHECK(overlap(Triangle{{2, 0, 0.5}, {0, 2, 0.5}, {2, 2, 0.5}}, unit_box));  // touches the edge x = y = 1
}

TEST_CASE("Degenerate triangles, segments and points, overlap a box like others") {
  CHECK(overlap(Triangle{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, unit_box));
  CHECK(overlap(Triangle{{-1, -1, -1}, {2, 2, 2}, {3, 3, 3}}, unit_box));
  CHECK_FALSE(overlap(Triangle{{2.5, 0, 0.5}, {0, 2.5, 0.5}, {1.25, 1.25, 0.5}}, unit_box));
}
