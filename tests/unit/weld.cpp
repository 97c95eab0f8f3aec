#include "first_contact/geometry/weld.hpp"

#include <random>

#include "catch.hpp"

using namespace first_contact;

TEST_CASE("Points at the very same position go by the lowest number there", "[weld]") {
  const std::vector<Point> points{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0, 0, -0.0}, {1, 2, 3}};
  CHECK(welded(points) == std::vector<std::uint32_t>{0, 1, 0, 1, 0});
  CHECK(welded({}).empty());
}

TEST_CASE("Points that differ in the last bit are two, and so are those whose coordinates are exchanged",
          "[weld]") {
  const std::vector<Point> points{{1, 2, 3}, {std::nextafter(1, 2), 2, 3}, {2, 1, 3}, {3, 2, 1}};
  CHECK(welded(points) == std::vector<std::uint32_t>{0, 1, 2, 3});
}

TEST_CASE("Welding a crowd of points finds what comparing all of them finds", "[weld]") {
  const unsigned seed = 1;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> few(-2, 2);
  std::vector<Point> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(few(random), few(random) * 0x1p-40, few(random) * 1e300);
  const std::vector<std::uint32_t> lowest = welded(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    CHECK(lowest[i] == std::ranges::find(points, points[i]) - points.begin());
}
