#include "first_contact/geometry/box.hpp"

#include <algorithm>
#include <limits>

#include "catch.hpp"

using namespace first_contact;

namespace {

const Box brick{{1, 2, 3}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}};
constexpr double infinity = std::numeric_limits<double>::infinity();

double farthest_vertex(const Box& box, const Vector& unit) {
  double farthest = -infinity;
  for (const Point& vertex : box.vertices()) farthest = std::max(farthest, (vertex - box.center).dot(unit));
  return farthest;
}

}  // namespace

TEST_CASE("The effective radius is how far the farthest vertex reaches") {
  for (const Vector& n :
       {Vector(1, 0, 0), Vector(0, -1, 0), Vector(0.6, 0, -0.8), Vector(-2, 3, 6).normalized()})
    CHECK(brick.effective_radius(n) == Approx(farthest_vertex(brick, n)));
}
TEST_CASE(
    "The effective radius of a cube is half its side across a face, and half its diagonal across a corner") {
  const Box cube{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  CHECK(cube.effective_radius({0, 0, 1}) == 1);
  CHECK(cube.effective_radius(Vector(1, 1, 1).normalized()) == Approx(std::sqrt(3.0)));
}
TEST_CASE("Bits 0, 1, 2 of a vertex's number are the signs of R, S, T") {
  CHECK(brick.vertices()[0] == Point(-1, 1, 2.5));
  CHECK(brick.vertices()[1] == Point(3, 1, 2.5));
  CHECK(brick.vertices()[2] == Point(-1, 3, 2.5));
  CHECK(brick.vertices()[4] == Point(-1, 1, 3.5));
}
TEST_CASE("A box may be flat") {
  const Box rod{{0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  CHECK(rod.effective_radius({1, 0, 0}) == 1);
  CHECK(rod.effective_radius({0, 1, 0}) == 0);
}
TEST_CASE("Axes typed with seven digits count as perpendicular, slanted ones are refused by name") {
  CHECK_NOTHROW(Box({0, 0, 0}, {0.8660254, 0.5, 0}, {-0.4999999, 0.8660254, 0}, {0, 0, 1}));
  CHECK_NOTHROW(Box({0, 0, 0}, {0.5773503, 0.5773503, 0.5773503}, {0.7071068, -0.7071068, 0},
                    {0.4082483, 0.4082483, -0.8164966}));
  CHECK_THROWS_WITH(Box({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1e-6, 1}),
                    ContainsSubstring("S, T") && ContainsSubstring("perpendicular"));
}
TEST_CASE("Whether axes are perpendicular does not depend on their length") {
  for (const double scale : {1e-300, 1e-200, 1.0, 1e200, 1e300}) {
    CAPTURE(scale);
    CHECK_NOTHROW(Box({0, 0, 0}, {scale, scale, 0}, {-scale, scale, 0}, {0, 0, scale}));
    CHECK_THROWS(Box({0, 0, 0}, {scale, 0, 0}, {scale, scale, 0}, {0, 0, scale}));
  }
}
TEST_CASE("A box with a coordinate that is not finite is refused by name") {
  CHECK_THROWS_WITH(Box({infinity, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), ContainsSubstring("centre"));
  CHECK_THROWS_WITH(Box({0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}, {0, 0, 1}), ContainsSubstring("axis S"));
  CHECK_THROWS_WITH(Box({0, 0, 0}, {1e301, 0, 0}, {0, 1e301, 0}, {0, 0, 1}), ContainsSubstring("lengths"));
}
