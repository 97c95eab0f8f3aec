#include "first_contact/motion/sweep_rigid.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "first_contact/sweep/box_box.hpp"

using namespace first_contact;

namespace {

constexpr double pi = std::numbers::pi;
const Plane ground{{0, 0, 1}, 0};
const Quaternion upright(1, 0, 0, 0);

Quaternion about_y(double angle) { return {std::cos(angle / 2), 0, std::sin(angle / 2), 0}; }

// A box of 2 x 4 x 1 whose origin is on its lower left edge.
const Box brick{{1, 0, 0.5}, {2, 0, 0}, {0, 4, 0}, {0, 0, 1}};

}  // namespace

TEST_CASE("A leaning box falls onto its face at the time at which its easing has turned it by that angle") {
  const double lean = pi / 6;
  for (const Easing& easing : {Easing(ease::linear), Easing(ease::in_quadratic), Easing(ease::in_out_sine)}) {
    const RigidTween tween({{10, {0, 0, 0}, about_y(-lean), easing}, {12, {0, 0, 0}, about_y(lean)}});
    const auto contact = sweep(tween, brick, ground);
    REQUIRE(contact);
    CHECK(easing((contact->time - 10) / 2) == Approx(0.5).margin(1e-6));
    CHECK(easing((contact->time - 10) / 2) <= 0.5);
    CHECK(contact->feature == Feature::face);
  }
}

TEST_CASE("A falling box lands on the plane, on a mesh and on a box of the same height at the same time") {
  const RigidTween fall({{0, {0, 0, 5}, about_y(0.3), ease::in_quadratic}, {2, {1, 0, -3}, about_y(1)}});
  const Mesh floor({{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Box block{{0, 0, -1}, {40, 0, 0}, {0, 40, 0}, {0, 0, 2}};
  const auto on_plane = sweep(fall, brick, ground), on_mesh = sweep(fall, brick, floor),
             on_box = sweep(fall, brick, block);
  REQUIRE(on_plane);
  REQUIRE(on_mesh);
  REQUIRE(on_box);
  const double bound = turning_gap * 20;  // it falls by more than 1 in a unit of time
  CHECK(on_mesh->time == Approx(on_plane->time).margin(bound));
  CHECK(on_box->time == Approx(on_plane->time).margin(bound));
  CHECK((on_mesh->normal - Vector(0, 0, 1)).norm() < 1e-6);
  double lowest = 1;
  for (const Point& p : fall.at(on_plane->time).box(brick).vertices()) lowest = std::min(lowest, p.z());
  CHECK(lowest >= 0);
  CHECK(lowest <= bound);
}

TEST_CASE("A body along a curve at constant speed that turns as it goes stops within the gap") {
  const Path path = Path::bezier({{2, 0, -6}, {6, 1, -2}}, true);
  const RigidTween tween({{0, {0, 0, 4}, upright, ease::in_out_cubic, path}, {1, {8, 0, 4}, about_y(2.5)}});
  const auto contact = sweep(tween, brick, ground);
  REQUIRE(contact);
  const double gap = turning_gap * 8;
  const auto lowest_at = [&](double time) {
    double lowest = 1e9;
    for (const Point& p : tween.at(time).box(brick).vertices()) lowest = std::min(lowest, p.z());
    return lowest;
  };
  CHECK(lowest_at(contact->time) <= gap);
  for (int i = 0; i <= 2000; ++i) CHECK(lowest_at(contact->time * i / 2000) >= 0);
}

TEST_CASE(
    "A body that only turns touches at the same time on a path of no length, led by its length or not") {
  std::vector<double> times;
  for (const bool by_length : {false, true}) {
    const Path nowhere = Path::bezier({{0, 0, 0}}, by_length);
    const auto contact =
        sweep(RigidTween({{0, {0, 0, 0}, about_y(-1), ease::linear, nowhere}, {1, {0, 0, 0}, about_y(1)}}),
              brick, ground);
    REQUIRE(contact);
    CHECK(contact->time == Approx(0.5).margin(1e-6));
    times.push_back(contact->time);
  }
  CHECK(times[0] == times[1]);
}

TEST_CASE("A box that spins a millionth above another does not touch it, and a millionth within it does") {
  const Box cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Quaternion quarter(std::cos(pi / 4), 0, 0, std::sin(pi / 4));
  const auto spin = [&](double height) {
    return RigidTween({{0, {0, 0, height}, upright}, {1, {0, 0, height}, quarter}});
  };
  CHECK_FALSE(sweep(spin(1.000001), cube, cube));
  CHECK(sweep(spin(0.999999), cube, cube)->time == 0);
}

TEST_CASE("A thin wall is not jumped over, however fast the body spins by") {
  const Mesh wall({{5, -9, -9}, {5, 9, -9}, {5, 0, 20}}, {{0, 1, 2}});
  const RigidTween tween({{0, {0, 0, 0}, upright}, {0.001, {50, 0, 0}, about_y(3)}});
  const auto contact = sweep(tween, brick, wall);
  REQUIRE(contact);
  CHECK(contact->triangle == 0);
  CHECK_FALSE(sweep(tween, brick, wall, Interval(0, 0.9 * contact->time)));
}

TEST_CASE("A body lifts off again from the floor on which it has landed") {
  const Mesh floor({{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const RigidTween down({{0, {0, 0, 3}, about_y(0.3)}, {1, {0, 0, -3}, about_y(0.3)}});
  const auto landing = sweep(down, brick, floor);
  REQUIRE(landing);
  const Point there = down.at(landing->time).translation();
  const RigidTween up({{0, there, about_y(0.3)}, {1, there + Vector(0, 0, 3), about_y(1)}});
  CHECK_FALSE(sweep(up, brick, floor));
  const RigidTween on({{0, there, about_y(0.3)}, {1, there - Vector(0, 0, 3), about_y(0.3)}});
  REQUIRE(sweep(on, brick, floor));
  CHECK(sweep(on, brick, floor)->time == 0);
}

TEST_CASE("A rigid body in a scene scaled by a power of two touches at the same time, bit by bit") {
  const auto touch = [](double size) {
    const RigidTween tween(
        {{0, {0, 0, 4 * size}, about_y(0.4), ease::in_cubic, Path::bezier({{2 * size, 0, 0}}, true)},
         {1, {4 * size, 0, -4 * size}, about_y(2)}});
    const Box box{size * brick.center, size * brick.r, size * brick.s, size * brick.t};
    return sweep(tween, box, ground)->time;
  };
  for (const double size : {0x1p-300, 0x1p-30, 0x1p30, 0x1p300, 0x1p900}) CHECK(touch(size) == touch(1));
}
