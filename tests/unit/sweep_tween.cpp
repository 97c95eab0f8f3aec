#include "first_contact/motion/sweep_tween.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;

namespace {

const Plane ground{{0, 0, 1}, 0};

// Down from 3 to -1 within a second: a ball of radius 1 touches the ground at half of its way.
Tween fall(Easing easing) { return Tween({{0, {0, 0, 3}, std::move(easing)}, {1, {0, 0, -1}}}); }

// Along x, round a quarter of a parabola, and along y: lengths 3, 1 + asinh(1) / sqrt(2), and 2.
const double bend = 1 + std::asinh(1.0) / std::sqrt(2.0);
Path corner() { return Path::of_legs({Path(), Path::bezier({{4, 0, 0}}), Path()}, {{3, 0, 0}, {4, 1, 0}}); }

}  // namespace

TEST_CASE("A straight tween meets the ground when its easing has done half of the way, for every easing") {
  for (const ease::Named& named : ease::all()) {
    CAPTURE(named.name);
    const auto touch = sweep(fall(named.easing), 1, ground);
    REQUIRE(touch);
    CHECK(named.easing(touch->time) == Approx(0.5).margin(1e-14));
    for (double t = 0; t < touch->time; t += 1.0 / 4096) CHECK(named.easing(t) < 0.5);
    CHECK(touch->point() == Point(0, 0, 0));
    CHECK(touch->normal == Vector(0, 0, 1));
  }
}

TEST_CASE("Times that have a formula are met exactly: linear, quadratic, cubic, circular") {
  CHECK(sweep(fall(ease::linear), 1, ground)->time == 0.5);
  CHECK(sweep(fall(ease::in_quadratic), 1, ground)->time == Approx(std::sqrt(0.5)).epsilon(4e-16));
  CHECK(sweep(fall(ease::in_cubic), 1, ground)->time == Approx(std::cbrt(0.5)).epsilon(4e-16));
  CHECK(sweep(fall(ease::in_circular), 1, ground)->time == Approx(std::sqrt(0.75)).epsilon(4e-16));
}

TEST_CASE("A ball meets a ball at a rational point of the circle, on the tween's own clock") {
  // Along y = 3/5 with radii 3/4 and 1/4: they touch where x = -4/5, after 12/25 of the way from -16/5 to 9/5.
  const Tween pass({{100, {-3.2, 0.6, 0}}, {125, {1.8, 0.6, 0}}});
  const auto touch = sweep(pass, 0.25, Sphere{{0, 0, 0}, 0.75});
  REQUIRE(touch);
  CHECK(touch->time == Approx(112).epsilon(1e-15));
  CHECK((touch->normal - Vector(-0.8, 0.6, 0)).norm() < 1e-14);
  CHECK((touch->point() - Point(-0.6, 0.45, 0)).norm() < 1e-14);
}

TEST_CASE("Through easing and curve: 4 (1 - 2u)^2 = 1 at u = 1/4, which in-quadratic comes to at half time") {
  const Tween dive({{2, {0, 0, 4}, ease::in_quadratic, Path::bezier({{2, 0, -4}})}, {4, {4, 0, 4}}});
  const auto touch = sweep(dive, 1, ground);
  REQUIRE(touch);
  const double gap =
      4 * tween_gap;  // the scene's size is 4, and the ball comes down by 4 in one unit of time
  CHECK(touch->time <= 3 + 1e-15);
  CHECK(touch->time >= 3 - gap / 4 * 1.01);
}

TEST_CASE("Over several legs at one speed the time is the length that is behind") {
  const Tween walk({{0, {0, 0, 0}, ease::linear, corner()}, {10, {4, 3, 0}}});
  const auto touch = sweep(walk, 0.5, Plane({0, -1, 0}, 2.5));  // its centre stops at y = 2
  REQUIRE(touch);
  CHECK(touch->time == Approx(10 * (4 + bend) / (5 + bend)).epsilon(1e-11));
  const auto in_the_bend = sweep(walk, 0.5, Plane({-1, 0, 0}, 4.25));  // ... at x = 3.75, half way round
  REQUIRE(in_the_bend);
  CHECK(in_the_bend->time == Approx(10 * (3 + bend / 2) / (5 + bend)).margin(1e-7));
}

TEST_CASE(
    "An easing that takes a run-up meets the wall behind the start, one that overshoots the wall behind the "
    "goal") {
  const auto run = [](Easing easing) { return Tween({{0, {0, 0, 0}, easing}, {1, {10, 0, 0}}}); };
  const Plane behind({1, 0, 0}, 1.5),
      beyond({-1, 0, 0}, 11.5);  // a ball of radius 1: its centre at -0.5, at 10.5
  const auto back = sweep(run(ease::in_back), 1, behind);
  REQUIRE(back);
  CHECK(ease::in_back(back->time) == Approx(-0.05).margin(1e-14));
  CHECK(back->time < Easing(ease::in_back).turns()[0]);
  CHECK_FALSE(sweep(run(ease::in_quadratic), 1, behind));
  for (const Easing& easing : {Easing(ease::out_back), Easing(ease::out_elastic)}) {
    const auto over = sweep(run(easing), 1, beyond);
    REQUIRE(over);
    CHECK(easing(over->time) == Approx(1.05).margin(1e-14));
    for (double t = 0; t < over->time; t += 1.0 / 4096) CHECK(easing(t) < 1.05);
  }
  CHECK_FALSE(sweep(run(ease::out_bounce), 1, beyond));
}

TEST_CASE("At constant speed a curve goes straight on where its easing overshoots, and is swept there") {
  const Tween tween(
      {{0, {0, 0, 0}, ease::out_back, Path::bezier({{4, 0, 0}, {8, 0, 0}}, true)}, {1, {10, 0, 0}}});
  const auto touch = sweep(tween, 1, Plane({-1, 0, 0}, 11.5));
  REQUIRE(touch);
  CHECK(tween.at(touch->time).x() == Approx(10.5).epsilon(1e-12));
}

TEST_CASE("A jump does not get through a wall: the contact is just before it") {
  const Tween jump({{0, {0, 0, 3}, Easing([](double t) { return t < 0.5 ? 0 : 1; })}, {1, {0, 0, -3}}});
  const auto touch = sweep(jump, 1, ground);
  REQUIRE(touch);
  CHECK(touch->time == std::nextafter(0.5, 0));
}

TEST_CASE("An interval of the clock is swept alone, and may begin between two keys") {
  const Tween hops({{0, {0, 0, 3}}, {1, {0, 0, 0.5}}, {2, {0, 0, 3}}, {3, {0, 0, 0.5}}});
  CHECK(sweep(hops, 1, ground)->time == Approx(0.8).epsilon(1e-15));
  CHECK_FALSE(sweep(hops, 1, ground, Interval(0, 0.75)));
  CHECK(sweep(hops, 1, ground, Interval(0.9, 3))->time == 0.9);  // it is in the ground, and goes deeper
  CHECK(sweep(hops, 1, ground, Interval(1, 3))->time == Approx(2.8).epsilon(1e-15));  // it is on its way out
  CHECK(sweep(hops, 1, ground, Interval(-5, 99))->time == Approx(0.8).epsilon(1e-15));
  CHECK_FALSE(sweep(hops, 1, ground, Interval(7, 9)));
}

TEST_CASE("What rests meets nothing, and neither does a tween with one key") {
  CHECK_FALSE(sweep(Tween({{0, {0, 0, 0.5}}}), 1, ground));
  CHECK_FALSE(sweep(Tween({{0, {0, 0, 0.5}}, {1, {0, 0, 0.5}, ease::linear}}), 1, ground));
  CHECK_FALSE(
      sweep(Tween({{0, {0, 0, 0.5}, ease::linear, Path::bezier({}, true)}, {1, {0, 0, 0.5}}}), 1, ground));
}

TEST_CASE("The rate of frames does not change what is hit or when") {
  const Tween dive({{0, {0, 0, 4}, ease::in_out_sine, Path::bezier({{2, 1, -4}, {3, 0, -5}}, true)},
                    {1, {4, 0, 4}, ease::out_back, Path::through({{5, 1, 3}, {6, 0, 5}})},
                    {2.5, {8, 0, 3}}});
  const auto whole = sweep(dive, 1, ground);
  REQUIRE(whole);
  const double bound = 2 * 8 * tween_gap;  // it comes down by more than 1 in a unit of time
  for (const int rate : {3, 12, 24, 25, 30, 50, 60, 144, 1000}) {
    std::optional<Contact> framed;
    for (int frame = 0; !framed && frame < 3 * rate; ++frame)
      framed = sweep(dive, 1, ground, Interval(double(frame) / rate, double(frame + 1) / rate));
    CAPTURE(rate);
    REQUIRE(framed);
    CHECK(framed->time == Approx(whole->time).margin(bound));
    CHECK((framed->point() - whole->point()).norm() < 100 * bound);
  }
}

TEST_CASE(
    "A curve's parameter taken for a part of the time is wrong by the easing: the mistake that this avoids") {
  const Tween dive(
      {{0, {0, 0, 4}, ease::in_cubic, Path::bezier({{2, 1, -4}, {3, 0, -5}}, true)}, {2, {4, 0, 4}}});
  const double u = sweep_along(dive.curve(0), 1, ground, 1e-7)->time, wrong = std::lerp(0.0, 2.0, u);
  const double right = sweep(dive, 1, ground)->time;
  CHECK(dive.at(right).z() == Approx(1).margin(1e-7));
  CHECK(std::abs(dive.at(wrong).z() - 1) > 1);
}

TEST_CASE("A tween in a scene scaled by a power of two touches at the same time, bit by bit") {
  const auto dive = [](double size) {
    return Tween({{0, {0, 0, 4 * size}, ease::in_out_back, Path::bezier({{2 * size, size, -4 * size}}, true)},
                  {1, {4 * size, 0, 4 * size}}});
  };
  const double time = sweep(dive(1), 1, ground)->time;
  for (const double size : {0x1p-300, 0x1p-40, 0x1p40, 0x1p300, 0x1p900}) {
    CAPTURE(size);
    CHECK(sweep(dive(size), size, ground)->time == time);
  }
}

TEST_CASE("A radius that is negative, or no number, is refused") {
  for (const double radius : {-1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(sweep(fall(ease::linear), radius, ground), std::invalid_argument);
}
