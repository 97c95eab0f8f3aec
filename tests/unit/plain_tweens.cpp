// The tweens that the essays write first, some ten lines each: that they are right, and what breaks them.
#include <cmath>

#include "07_tween_bounce/plain_length.hpp"
#include "07_tween_bounce/plain_play.hpp"
#include "07_tween_bounce/plain_slerp.hpp"
#include "07_tween_bounce/plain_sweep_along.hpp"
#include "catch.hpp"
#include "first_contact/motion/arc_length.hpp"
#include "first_contact/motion/play.hpp"
#include "first_contact/motion/rigid_tween.hpp"
#include "first_contact/program/random.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

using namespace first_contact;

TEST_CASE(
    "A curve swept by a few chords, as one writes it first, comes nearer to its contact with more of them") {
  const Bezier down({{0, 0, 3}, {1, 0, 2}, {2, 0, -4}});
  const Plane floor({0, 0, 1}, 0);
  const double time = sweep_along(Curve(down), 0.5, floor, 1e-8)->time;
  const auto error = [&](int chords) {
    return std::abs(*tween_bounce::plain_sweep_along(Curve(down), 0.5, floor, chords) - time);
  };
  CHECK(error(4) > 1e-3);
  CHECK(error(64) < 1e-4);
}

TEST_CASE("A curve swept by a few chords, as one writes it first, loses a dip between two of their ends") {
  const Bezier dip({{0, 0, 2}, {1, 0, -1.2}, {2, 0, 2}});  // as low as 0.4
  const Plane floor({0, 0, 1}, 0);
  CHECK_FALSE(tween_bounce::plain_sweep_along(Curve(dip), 0.5, floor, 3));
  CHECK(sweep_along(Curve(dip), 0.5, floor, 1e-8)->time == Approx(0.5 - std::sqrt(0.1 / 6.4)).margin(1e-6));
}

TEST_CASE(
    "The turn as one writes it first is the library's between orientations less than half a turn apart") {
  std::mt19937 random(15);
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const Rigid from = Rigid::turned(program::unit_vector(random), 3 * program::uniform(random));
    const Rigid by = Rigid::turned(program::unit_vector(random), 1.5 + 1.4 * program::uniform(random));
    const Quaternion a(Eigen::Quaterniond(from.rotation())),
        b = a * Quaternion(Eigen::Quaterniond(by.rotation()));
    if (a.dot(b) < 0.01) continue;
    const double s = 0.5 + program::uniform(random) / 2;
    const RigidTween tween({{0, {0, 0, 0}, a}, {1, {0, 0, 0}, b}});
    const Eigen::Matrix3d plain = Eigen::Quaterniond(tween_bounce::plain_slerp(a, b, s)).toRotationMatrix();
    CHECK((plain - tween.at(s).rotation()).norm() < 1e-12);
  }
}

TEST_CASE("The turn as one writes it first loses a body that does not turn, and the library's keeps it") {
  const Quaternion a(1, 0, 0, 0);
  CHECK(std::isnan(tween_bounce::plain_slerp(a, a, 0.5).w()));
  const RigidTween still({{0, {0, 0, 0}, a}, {1, {0, 0, 0}, a}});
  CHECK(still.at(0.5).rotation() == Eigen::Matrix3d::Identity());
  CHECK(tween_bounce::lost_at_rest(1000) > 500);
}

TEST_CASE(
    "The turn as one writes it first goes the long way round where the four numbers have the other sign") {
  const Quaternion a(1, 0, 0, 0), b(-std::cos(0.5), 0, 0, -std::sin(0.5));  // by 1 about the z axis
  const Quaternion plain = tween_bounce::plain_slerp(a, b, 0.5);
  CHECK(std::abs(std::sin(2 * std::atan2(plain.z(), plain.w()) - 0.5)) < 1e-12);
  CHECK(std::cos(2 * std::atan2(plain.z(), plain.w()) - 0.5) == Approx(-1));  // half a turn off
  const RigidTween tween({{0, {0, 0, 0}, a}, {1, {0, 0, 0}, b}});
  CHECK(tween.at(0.5).rotation()(1, 0) == Approx(std::sin(0.5)));
}

TEST_CASE("A tween as one plays it first is its plan where nothing is in the way") {
  const Tween plan({{0, {0, 0, 3}, ease::in_quadratic}, {1, {2, 0, 1}}});
  const Plane floor({0, 0, 1}, 0);
  const auto meets = [&](const Moving<Sphere>& moving) { return sweep(moving, floor); };
  const auto places = tween_bounce::plain_play(plan, 0.5, meets, 0.6, 8);
  REQUIRE(places.size() == 9);
  for (int i = 0; i <= 8; ++i) CHECK((places[static_cast<std::size_t>(i)] - plan.at(i / 8.0)).norm() < 1e-15);
}

TEST_CASE(
    "A tween as one plays it first ends elsewhere for each number of pictures, and comes nearer with more") {
  const Tween plan({{0, {0, 0, 3}}, {1, {2, 0, -2.5}}});
  const Plane floor({0, 0, 1}, 0);
  const auto meets = [&](const Moving<Sphere>& moving) { return sweep(moving, floor); };
  const Point last = play(plan, 0.5, floor, After::bounce(0.6)).at(1);
  CHECK(last.z() == Approx(0.5 + 0.6 * 3));
  const auto error = [&](double pictures) {
    return (tween_bounce::plain_play(plan, 0.5, meets, 0.6, pictures).back() - last).norm();
  };
  CHECK(error(7) > 0.3);
  CHECK(error(60) > 0.03);
  CHECK(error(7) > 2 * error(60));
  CHECK(error(100000) < 1e-4);
}

TEST_CASE(
    "The length as one writes it first is always short, and ten times the chords give two digits more") {
  const Curve arch = Bezier({{0, 0, 0}, {1, 0, 4}, {3, 0, 4}, {9, 0, 0}});
  const double length = ArcLength(arch).total();
  const auto lacks = [&](int chords) { return length - tween_bounce::plain_length(arch, chords); };
  CHECK(lacks(10) > 0);
  CHECK(lacks(10) / lacks(100) == Approx(100).epsilon(0.05));
  CHECK(lacks(100) / lacks(1000) == Approx(100).epsilon(0.01));
  CHECK(tween_bounce::plain_length(Bezier({{0, 0, 0}, {3, 4, 0}}), 7) == Approx(5));
}
