#include "first_contact/motion/sweep_rigid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/geometry/largest_coordinate.hpp"
#include "first_contact/geometry/triangle_distance.hpp"

using namespace first_contact;

namespace {

double away(const Mesh& body, const Plane& plane, double side) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point& p : body.vertices()) least = std::min(least, side * plane.signed_distance(p));
  return least;
}

double away(const Mesh& body, const Mesh& obstacle) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& a : body.triangles())
    for (const Triangle& b : obstacle.triangles()) least = std::min(least, nearest_points(a, b).distance());
  return least;
}

Mesh standing(const Mesh& body, const Rigid& pose) {
  std::vector<Point> vertices;
  for (const Point& p : body.vertices()) vertices.push_back(pose.point(p));
  return {vertices, body.faces()};
}

RigidTween some_tween(Chance& chance) {
  std::vector<Pose> poses;
  double time = chance.uniform(-3, 3);
  for (std::size_t k = 2 + chance.pick(2); k > 0; --k) {
    const Quaternion turn(Eigen::AngleAxisd(chance.uniform(-3, 3), chance.direction()));
    const Easing easing = ease::all()[chance.pick(ease::all().size())].easing;
    const Point place = chance.vector(4), pull = chance.vector(4);
    const Path path = chance.pick(3) == 0 ? Path() : Path::bezier({pull}, chance.pick(2) == 0);
    poses.push_back({time, place, turn, easing, path});
    time += chance.log_uniform(0.01, 10);
  }
  return RigidTween(std::move(poses));
}

double size_of(const RigidTween& tween, double other) {
  double size = std::max(2.0, other);
  for (const Leg& leg : tween.legs()) size = std::max(size, largest_coordinate(leg.curve()));
  return size;
}

}  // namespace

// Distances from below the gap up, tilts of the axis from none to what closes the distance, and sinking.
TEST_CASE("A lid that turns near a face is never nearer than its contact says, and touches within the gap") {
  const std::uint64_t seed = 1312;
  Chance chance(seed);
  int hits = 0;
  const Mesh floor({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, {{0, 1, 2}, {0, 2, 3}});
  for (int i = 0; i < 150; ++i) {
    const double height = chance.log_uniform(1e-8, 1e-2), tilt = height * chance.log_uniform(1e-3, 10);
    const double sunk = chance.pick(2) == 0 ? 0 : height * chance.uniform(-2, 1);
    const Vector axis = Vector(0, 0, 1) + (chance.pick(3) == 0 ? 0 : tilt) * chance.direction();
    const Mesh lid = surface_of({{0.1, 0, height + 0.25}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}});
    const Turning<Mesh> turning(lid, chance.vector(1), axis, chance.uniform(-6, 6),
                                {chance.uniform(-1, 1), 0, sunk});
    const double gap = turning_gap * 4, until_end = away(lid, floor);
    const auto contact = sweep(turning, floor, {turning_gap * 4});
    const double until = contact ? contact->time : 1;
    CAPTURE(seed, i, height, tilt, sunk, until);
    for (int k = 0; k <= 60; ++k)
      REQUIRE(away(turned(turning, until * k / 60), floor) >= std::min(0.49 * gap, until_end - 0.51 * gap));
    if (contact) REQUIRE(away(turned(turning, until), floor) <= 1.01 * gap);
    hits += contact.has_value();
  }
  CHECK(hits > 20);
  CHECK(hits < 140);
}

TEST_CASE(
    "Before the contact of a random body that turns dense sampling finds none, and at it the gap is closed") {
  const std::uint64_t seed = 1311;
  Chance chance(seed);
  int hits = 0, tried = 0;
  for (int i = 0; i < 60; ++i) {
    const RigidTween tween = some_tween(chance);
    const Mesh body =
        surface_of({chance.vector(0.5), {chance.uniform(0.1, 1), 0, 0}, {0, 0.5, 0}, {0, 0, 1}});
    const Plane plane(chance.direction(), chance.uniform(-4, 4));
    const Mesh surface({chance.vector(4), chance.vector(4), chance.vector(4), chance.vector(4)},
                       {{0, 1, 2}, {1, 2, 3}});
    const auto at = [&](double time) { return standing(body, tween.at(time)); };
    const double side = plane.signed_distance(at(tween.begin()).vertices()[0]) < 0 ? -1 : 1;
    CAPTURE(seed, i);
    if (away(at(tween.begin()), plane, side) > 0.01) {
      const auto contact = sweep(tween, body, plane);
      const double until = contact ? contact->time : tween.end();
      const double gap = turning_gap * size_of(tween, largest_coordinate(plane));
      for (int k = 0; k <= 500; ++k)
        REQUIRE(away(at(std::lerp(tween.begin(), until, k / 500.0)), plane, side) >= -1e-13);
      if (contact) REQUIRE(away(at(until), plane, side) <= 1.01 * gap);
      ++tried, hits += contact.has_value();
    }
    if (away(at(tween.begin()), surface) > 0.01) {
      const auto contact = sweep(tween, body, surface);
      const double until = contact ? contact->time : tween.end();
      const double gap = turning_gap * size_of(tween, largest_coordinate(surface));
      for (int k = 0; k <= 100; ++k)
        REQUIRE(away(at(std::lerp(tween.begin(), until, k / 100.0)), surface) > 0);
      if (contact) REQUIRE(away(at(until), surface) <= 1.01 * gap);
      ++tried, hits += contact.has_value();
    }
  }
  CHECK(tried > 60);
  CHECK(hits > tried / 4);
  CHECK(hits < tried);
}
