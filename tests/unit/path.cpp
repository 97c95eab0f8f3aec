#include "first_contact/motion/path.hpp"

#include <cmath>

#include "catch.hpp"
#include "first_contact/motion/tween.hpp"

using namespace first_contact;

namespace {

// Along x, round a quarter of a parabola, and along y: lengths 3, about 1.6232, and 2.
Path corner(bool by_length) {
  return Path::of_legs({Path(), Path::bezier({{4, 0, 0}}), Path()}, {{3, 0, 0}, {4, 1, 0}}, by_length);
}

const Point start(0, 0, 0), goal(4, 3, 0);

}  // namespace

TEST_CASE("A path of several legs goes through its joints and ends at the key") {
  const Leg leg(corner(false), start, goal);
  CHECK(leg.at(0) == start);
  CHECK(leg.at(1) == goal);
  CHECK((leg.at(1.0 / 3) - Point(3, 0, 0)).norm() < 1e-14);
  CHECK((leg.at(2.0 / 3) - Point(4, 1, 0)).norm() < 1e-14);
  CHECK((leg.at(1.0 / 6) - Point(1.5, 0, 0)).norm() < 1e-14);
}

TEST_CASE("Over several legs there is one length and one speed") {
  // The parabola (1 - u^2, ...) from (3, 0) by (4, 0) to (4, 1): 2 int_0^1 sqrt(2 u^2 - 2 u + 1) du.
  const double bend = 1 + std::asinh(1.0) / std::sqrt(2.0), total = 5 + bend;
  const Leg leg(corner(true), start, goal);
  REQUIRE(leg.by_length());
  CHECK(leg.by_length()->total() == Approx(total).epsilon(ArcLength::relative_error));
  CHECK((leg.at(1.5 / total) - Point(1.5, 0, 0)).norm() < 1e-11);
  CHECK((leg.at((3 + bend / 2) / total) - Point(3.75, 0.25, 0)).norm() < 1e-11);
  CHECK((leg.at((4 + bend) / total) - Point(4, 2, 0)).norm() < 1e-11);
  Point before = start;
  for (int i = 1; i <= 1000; ++i) {  // no step is longer than its part of the length
    const Point now = leg.at(i / 1000.0);
    CHECK((now - before).norm() <= total / 1000 * (1 + 1e-9));
    before = now;
  }
}

TEST_CASE("A path of legs of each kind joins them, a B-spline's pieces among them") {
  const Path path =
      Path::of_legs({Path::b_spline({{1, 2, 0}, {2, -1, 0}, {3, 2, 1}, {4, 0, 0}}),
                     Path::through({{6, 1, 0}, {7, -1, 0}}), Path::hermite({3, 3, 0}, {0, 0, 3})},
                    {{5, 0, 0}, {8, 0, 0}}, false);
  const Leg leg(path, {0, 0, 0}, {9, 9, 9});
  const auto spline = path.parts[0].from_to({0, 0, 0}, {5, 0, 0});
  for (double u = 0; u <= 1; u += 0.125) {
    CHECK((leg.at(u / 3) - at(spline, u)).norm() < 1e-13);
    CHECK((leg.at((2 + u) / 3) - hermite({8, 0, 0}, {3, 3, 0}, {9, 9, 9}, {0, 0, 3}).at(u)).norm() < 1e-13);
  }
  CHECK((leg.at(2.0 / 3) - Point(8, 0, 0)).norm() < 1e-13);
}

TEST_CASE("Key frames made smooth keep their times and places and lose their corners") {
  const std::vector<KeyFrame> keys{
      {0, {0, 0, 0}}, {1, {1, 2, 0}, ease::in_out_sine}, {3, {3, 0, 1}}, {4, {4, 4, 0}}};
  const Tween tween(smooth(keys));
  for (const KeyFrame& key : keys) CHECK(tween.at(key.time) == key.position);
  for (std::size_t i = 1; i < 3; ++i) {
    const Vector before = normalized(at(derivative(tween.curve(i - 1)), 1));
    const Vector after = normalized(at(derivative(tween.curve(i)), 0));
    CHECK((before - after).norm() < 1e-14);
  }
}

TEST_CASE("Legs without their joints are refused") {
  CHECK_THROWS_WITH(Path::of_legs({Path()}, {{1, 0, 0}}),
                    "path's legs: must be one more than the joints between them");
}
