#include "first_contact/motion/play.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "first_contact/motion/css_easing.hpp"
#include "first_contact/motion/easing_family.hpp"
#include "first_contact/motion/squash.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;

namespace {

const Plane ground{{0, 0, 1}, 0};
// Down and to the right; a ball of radius 1 touches at half time, in (2, 0, 1).
const Tween dive({{0, {0, 0, 3}}, {1, {4, 0, -1}}});

bool is_near(const Point& p, const Point& q, double margin = 1e-8) { return (p - q).norm() <= margin; }

}  // namespace

TEST_CASE("A rebound turns the motion round, and keeps what is along the surface") {
  CHECK(rebound({3, 0, -4}, {0, 0, 1}, Surface(1, 0)) * Vector(3, 0, -4) == Vector(3, 0, 4));
  CHECK(is_near(rebound({3, 0, -4}, {0, 0, 1}, Surface(0.5, 0)) * Vector(3, 0, -4), {3, 0, 2}, 1e-15));
  CHECK(is_near(rebound({3, 0, -4}, {0, 0, 1}, Surface(0, 0)) * Vector(3, 0, -4), {3, 0, 0}, 1e-15));
}

TEST_CASE("Friction takes mu (1 + e) v_n of the speed along the surface, but never turns it round") {
  const auto after = [](double e, double mu) -> Vector {
    return rebound({3, 0, -4}, {0, 0, 1}, Surface(e, mu)) * Vector(3, 0, -4);
  };
  CHECK(is_near(after(0.5, 0.25), {3 - 0.25 * 1.5 * 4, 0, 2}, 1e-15));
  CHECK(is_near(after(0.5, 0.5), {0, 0, 2}, 1e-15));
  CHECK(is_near(after(0.5, 9), {0, 0, 2}, 1e-15));
  CHECK_THROWS_WITH(Surface(1.5, 0), "restitution 1.5: must be in 0 .. 1");
  CHECK_THROWS_WITH(Surface(1, -1), "friction -1: must be finite and not negative");
}

TEST_CASE("A tween that stops stays where it touches") {
  const Played played = play(dive, 1, ground, After::stop());
  REQUIRE(played.contacts().size() == 1);
  CHECK(played.at(0.25) == dive.at(0.25));
  for (const double t : {0.5, 0.75, 1.0, 9.0}) CHECK(is_near(played.at(t), {2, 0, 1}));
}

TEST_CASE(
    "Where an easing jumps into a floor, the ball stops, slides or is thrown back from where it touches") {
  // In two steps, at half time from 2 to 0, and at the end to -2; it touches at 0.5.
  const Tween jumps({{0, {0, 0, 2}, ease::steps(2)}, {1, {0, 0, -2}}});
  for (const After& after : {After::stop(), After::slide()}) {
    const Played played = play(jumps, 0.5, ground, after);
    REQUIRE(played.contacts().size() == 1);
    CHECK(played.at(0.25) == Point(0, 0, 2));
    CHECK(is_near(played.at(0.75), {0, 0, 0.5}));
  }
  const Played thrown = play(jumps, 0.5, ground, After::bounce(1));
  CHECK(thrown.contacts().size() == 1);
  CHECK(is_near(thrown.at(thrown.contacts()[0].time), {0, 0, 0.5}));
  CHECK(is_near(thrown.at(0.75), {0, 0, 1}));
  CHECK(is_near(thrown.at(1), {0, 0, 3}));
}

TEST_CASE("A ball that is thrown back within a jump stops at what is in its way") {
  const Tween jumps({{0, {0, 0, 2}, ease::steps(1)}, {1, {0, 0, -6}}});  // to 7, were it not for the shelf
  const Triangle shelf({-9, -9, 3}, {9, -9, 3}, {0, 9, 3});
  const SphereSweep both = [&](const Moving<Sphere>& ball) {
    const auto floor = sweep(ball, ground), above = sweep(ball, shelf);
    return !above || (floor && floor->time < above->time) ? floor : above;
  };
  const Played played = play(jumps, 0.5, both, 9, After::bounce(1), 64);
  REQUIRE(played.contacts().size() == 2);
  CHECK(is_near(played.at(1), {0, 0, 2.5}));
}

TEST_CASE("Keys that are as near on the clock as two doubles can be miss nothing") {
  const Tween instant({{0, {0, 0, 3}}, {5e-324, {0, 0, -3}}});
  const Played played = play(instant, 0.5, ground, After::stop());
  REQUIRE(played.contacts().size() == 1);
  CHECK(is_near(played.at(5e-324), {0, 0, 0.5}));
}

TEST_CASE("Keys that are hardly apart on the clock are thrown back from where they touch") {
  const Tween late({{1e6 - 1e-5, {0, 0, 3}}, {1e6, {0, 0, -3}}});
  CHECK(is_near(play(late, 0.5, ground, After::bounce(1)).at(1e6), {0, 0, 4}));
}

TEST_CASE("A tween that slides goes on along the floor at its own speed, less by friction") {
  const Played played = play(dive, 1, ground, After::slide()),
               rough = play(dive, 1, ground, After::slide(0.5));
  CHECK(played.contacts().size() == 1);
  CHECK(is_near(played.at(0.75), {3, 0, 1}));
  CHECK(is_near(played.at(1), {4, 0, 1}));
  CHECK(is_near(rough.at(1), {3, 0, 1}));  // both speeds are alike: half of the one is lost
}

TEST_CASE("A tween that bounces goes on along its mirror image, flatter by the restitution") {
  CHECK(is_near(play(dive, 1, ground, After::bounce(1)).at(1), {4, 0, 3}));
  CHECK(is_near(play(dive, 1, ground, After::bounce(0.5)).at(1), {4, 0, 2}));
  CHECK(is_near(play(dive, 1, ground, After::bounce(0.5, 1.0 / 3)).at(1), {3, 0, 2}));
}

TEST_CASE("A curved path bounces as a curve, and comes down on the floor where its mirror image comes up") {
  const Tween arc({{0, {0, 0, 5}, ease::linear, Path::bezier({{2, 0, -7}, {4, 0, -7}})}, {1, {6, 0, 5}}});
  const Played played = play(arc, 1, ground, After::bounce(0.5));
  REQUIRE(played.contacts().size() == 2);
  const double first = played.contacts()[0].time, second = played.contacts()[1].time;
  CHECK(arc.at(first).z() == Approx(1).margin(1e-7));
  CHECK(first + second == Approx(1).margin(1e-7));  // the arc is its own mirror image
  for (int i = 0; i <= 1000; ++i) CHECK(played.at(i / 1000.0).z() >= 1 - 1e-7);
  CHECK(is_near(played.at(0.5), {3, 0, 1 + 0.5 * (1 - arc.at(0.5).z())}, 1e-7));
  CHECK(is_near(played.at(1), {6, 0, 1 + 0.25 * 4}, 1e-7));
}

TEST_CASE(
    "Beyond its end a curve goes on as it bends, or at constant speed straight on, and is thrown back so") {
  // x = 4 u and z = 1 + (3 - 2 u)(1 + 2 u) / 2: the ball comes down behind u = 1.
  const bool by_length = GENERATE(false, true);
  const Easing beyond = ease::out(ease::back(10));
  const Tween tween({{0, {0, 0, 2.5}, beyond, Path::bezier({{2, 0, 3.5}}, by_length)}, {1, {4, 0, 2.5}}});
  const Played played = play(tween, 1, ground, After::bounce(1, 0.25));
  REQUIRE(!played.contacts().empty());
  const Point touching = tween.at(played.contacts()[0].time);
  CHECK(is_near(touching, {by_length ? 7.0 : 6.0, 0, 1}, 1e-6));
  const double slope = by_length ? 0.5 : 1,
               farthest = beyond.turns()[0];  // by friction half of the slope is lost
  const Point there = tween.at(farthest), after = played.at(farthest);
  CHECK(after.x() == Approx(touching.x() + (1 - 0.5 * slope) * (there.x() - touching.x())).epsilon(1e-6));
  CHECK(after.z() == Approx(2 - there.z()).epsilon(1e-6));
}

TEST_CASE("In a corner a slide goes along the floor up to the wall, and stays there") {
  const Mesh corner(
      {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}, {3, -9, 9}, {3, 9, 9}, {3, -9, 0}, {3, 9, 0}},
      {{0, 1, 2}, {0, 2, 3}, {6, 4, 5}, {6, 5, 7}});
  const Played played = play(dive, 0.5, Environment(corner), After::slide());
  CHECK(played.contacts().size() >= 2);
  CHECK(is_near(played.at(1), {2.5, 0, 0.5}, 1e-7));
}

TEST_CASE("Of no more contacts than are allowed the last one stops it") {
  const Tween down({{0, {0, 0, 3}}, {1, {0, 0, -5}}});
  const Played played = play(down, 1, ground, After::bounce(1), 1);
  CHECK(played.contacts().size() == 1);
  CHECK(is_near(played.at(1), {0, 0, 1}));
}

TEST_CASE("Squash and stretch keep the volume: the determinant is 1 to within rounding") {
  for (const Vector& axis : {Vector(0, 0, 1), Vector(1, -2, 3), Vector(1e-200, 0, 1e-200)})
    for (const double stretch : {0.01, 0.5, 1.0, 1.7, 40.0}) {
      const Eigen::Matrix3d m = squash(axis, stretch);
      const double longest = std::max(stretch, 1 / std::sqrt(stretch)),
                   shortest = std::min(stretch, 1 / std::sqrt(stretch));
      const double eps = std::numeric_limits<double>::epsilon();
      CHECK(std::abs(m.determinant() - 1) <= 8 * eps * longest / shortest);
      CHECK(is_near(m * normalized(axis), stretch * normalized(axis), 8 * eps * longest));
    }
  CHECK(squash({0, 0, 2}, 4) * Vector(1, 1, 1) == Vector(0.5, 0.5, 4));
}

TEST_CASE("A stretch is eased by its ratio: half way from 1/4 to 4 is 1, and it never becomes 0") {
  CHECK(eased_stretch(0.25, 4, ease::linear, 0.5) == 1);
  CHECK(eased_stretch(0.25, 4, ease::linear, 0) == 0.25);
  CHECK(eased_stretch(0.25, 4, ease::linear, 1) == 4);
  for (int i = 0; i <= 100; ++i) CHECK(eased_stretch(0.5, 1, ease::out_elastic, i / 100.0) > 0);
  const Easing far = [](double t) { return t < 0.5 ? -5.0 : 6.0; };
  CHECK(eased_stretch(0x1p-100, 0x1p100, far, 0.25) == 0x1p-100);
  CHECK(eased_stretch(0x1p-100, 0x1p100, far, 0.75) == 0x1p100);
  CHECK_THROWS_AS(eased_stretch(0, 1, ease::linear, 0.5), std::invalid_argument);
  CHECK_THROWS_WITH(squash({0, 0, 0}, 1), "axis 0, 0, 0: must not be zero");
  CHECK_THROWS_AS(squash({0, 0, 1}, -1), std::invalid_argument);
}
