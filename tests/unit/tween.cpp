#include "first_contact/motion/tween.hpp"

#include <limits>

#include "catch.hpp"

using namespace first_contact;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Tween three_legs() {
  return Tween({{0.1, {0, 0, 0}},
                {0.4, {1, 2, 0}, ease::out_elastic, Path::bezier({{2, 5, 1}, {3, -1, 1}}, true)},
                {0.7, {4, 2, 1}, ease::in_out_back, Path::b_spline({{5, 0, 0}, {6, 3, 0}, {7, 0, 0}})},
                {1.9, {8, 0.3, 0}}});
}

}  // namespace

TEST_CASE("A tween is exactly at each key's position at that key's time") {
  const Tween tween = three_legs();
  for (const KeyFrame& key : tween.keys()) CHECK(tween.at(key.time) == key.position);
}

TEST_CASE("A tween stays at its first position before it begins, and at its last after it ends") {
  const Tween tween = three_legs();
  CHECK(tween.at(-1e9) == Point(0, 0, 0));
  CHECK(tween.at(2) == Point(8, 0.3, 0));
  CHECK(tween.at(std::numeric_limits<double>::infinity()) == Point(8, 0.3, 0));
}

TEST_CASE("A tween comes to its last key without a jump, whatever the easing") {
  const Tween tween = three_legs();
  CHECK((tween.at(1.9 - 1e-12) - Point(8, 0.3, 0)).norm() < 1e-6);
}

TEST_CASE("A straight tween goes half its way in half its time") {
  const Tween tween({{1, {0, 0, 0}}, {3, {4, 8, -2}}});
  CHECK(tween.at(2) == Point(2, 4, -1));
}

TEST_CASE("The easing says how far along a tween is") {
  const Tween tween({{0, {0, 0, 0}, ease::in_quadratic}, {1, {16, 0, 0}}});
  CHECK(tween.at(0.25) == Point(1, 0, 0));
}

TEST_CASE("An easing that overshoots goes beyond the key and comes back") {
  const Tween straight({{0, {0, 0, 0}, ease::out_back}, {1, {1, 0, 0}}});
  CHECK(straight.at(0.7).x() > 1.05);
  const Tween by_length({{0, {0, 0, 0}, ease::out_back, Path::bezier({{0.9, 0, 0}}, true)}, {1, {1, 0, 0}}});
  CHECK(by_length.at(0.7).x() == Approx(straight.at(0.7).x()).epsilon(1e-12));
}

TEST_CASE("With constant speed equal times are equal lengths of the path") {
  const Path path = Path::bezier({{0, 4, 0}, {3, 4, 0}}, true);
  const Tween tween({{0, {0, 0, 0}, ease::linear, path}, {1, {3, 0, 0}}});
  const ArcLength length(tween.curve(0));
  CHECK((tween.at(0.3) - length.at(0.3)).norm() < 1e-12);
}

TEST_CASE("A B-spline path with few points between takes the highest degree that it can") {
  CHECK(std::get<BSpline>(Path::b_spline({}).from_to({0, 0, 0}, {1, 0, 0})).degree() == 1);
  CHECK(std::get<BSpline>(Path::b_spline({{1, 1, 0}}).from_to({0, 0, 0}, {1, 0, 0})).degree() == 2);
  CHECK(std::get<BSpline>(Path::b_spline({{1, 1, 0}, {2, 1, 0}, {3, 0, 0}}).from_to({0, 0, 0}, {1, 0, 0}))
            .degree() == 3);
}

TEST_CASE("A tween with one key frame stays there") {
  CHECK(Tween({{5, {1, 2, 3}}}).at(7) == Point(1, 2, 3));
}

TEST_CASE("A tween whose times span all doubles still tweens") {
  const double most = std::numeric_limits<double>::max();
  CHECK(Tween({{-most, {0, 0, 0}}, {most, {2, 0, 0}}}).at(0) == Point(1, 0, 0));
}

TEST_CASE("Key frames are refused if there are none, or times do not ascend, or a value is not finite") {
  CHECK_THROWS_AS(Tween({}), std::invalid_argument);
  CHECK_THROWS_AS(Tween({{0, {0, 0, 0}}, {0, {1, 0, 0}}}), std::invalid_argument);
  CHECK_THROWS_AS(Tween({{1, {0, 0, 0}}, {0, {1, 0, 0}}}), std::invalid_argument);
  CHECK_THROWS_AS(Tween({{not_a_number, {0, 0, 0}}}), std::invalid_argument);
  CHECK_THROWS_AS(Tween({{0, {0, not_a_number, 0}}}), std::invalid_argument);
  CHECK_THROWS_AS(Tween({{0, {0, 0, 0}, ease::linear, Path::bezier({{not_a_number, 0, 0}})}, {1, {1, 0, 0}}}),
                  std::invalid_argument);
}

TEST_CASE("A refused key frame is named, with its value and the rule") {
  CHECK_THROWS_WITH(Tween({{0.5, {0, 0, 0}}, {0.25, {1, 0, 0}}}),
                    "tween's key frame 1, time 0.25: must be later than the one before");
}
