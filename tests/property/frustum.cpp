#include "first_contact/geometry/frustum.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "chance.hpp"

using namespace first_contact;

namespace {

struct Eye {
  double view, aspect, near_z, far_z;
  Rigid camera;

  Frustum frustum() const {
    return Frustum(Transform::perspective(view, aspect, near_z, far_z).after(camera.inverse().transform()));
  }
  /// The point at a depth, and at parts of the half height and half width there.
  Point seen(double depth, double x, double y) const {
    const double up = depth * std::tan(view / 2);
    return camera.point({x * up * aspect, y * up, -depth});
  }
};

Eye any_eye(Chance& chance) {
  const double near_z = chance.log_uniform(1e-9, 1e3);
  return {chance.uniform(0.01, 3.1), chance.log_uniform(0.1, 10), near_z,
          near_z * chance.log_uniform(1.01, 1e25),
          Rigid::moved_by(near_z * chance.vector(1))
              .after(Rigid::turned(chance.direction(), chance.uniform(0, 6)))};
}

}  // namespace

TEST_CASE("What is seen is never rejected, be the far plane as far as 1e25 times the near one") {
  const std::uint64_t seed = 1201;
  Chance chance(seed);
  for (int i = 0; i < 20000; ++i) {
    const Eye eye = any_eye(chance);
    const Frustum sight = eye.frustum();
    const double depth = std::min(eye.far_z, chance.log_uniform(eye.near_z, eye.far_z));
    const Point p = eye.seen(depth, chance.uniform(-0.999, 0.999), chance.uniform(-0.999, 0.999));
    CAPTURE(seed, i, depth / eye.far_z);
    REQUIRE_FALSE(rejected(sight, Sphere{p, 0}));
    REQUIRE_FALSE(rejected(sight, Box{p, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
  }
}

TEST_CASE("What is a thousandth beyond one of the six sides is rejected, be the far plane as far as it may") {
  const std::uint64_t seed = 1202;
  Chance chance(seed);
  for (int i = 0; i < 20000; ++i) {
    const Eye eye = any_eye(chance);
    const Frustum sight = eye.frustum();
    const double depth = chance.log_uniform(eye.near_z, eye.far_z);
    const double side = chance.pick(2) ? 1.001 : -1.001, other = chance.uniform(-1, 1);
    CAPTURE(seed, i);
    REQUIRE(rejected(sight, Sphere{eye.seen(1.001 * eye.far_z, other, 0), 0}));
    REQUIRE(rejected(sight, Sphere{eye.seen(0.999 * eye.near_z, 0, other), 0}));
    REQUIRE(rejected(sight, Sphere{eye.seen(depth, side, other), 0}));
    REQUIRE(rejected(sight, Sphere{eye.seen(depth, other, side), 0}));
  }
}

TEST_CASE("A sphere that touches a side, an edge or a corner of what is seen from outside is kept") {
  const std::uint64_t seed = 1203;
  Chance chance(seed);
  for (int i = 0; i < 20000; ++i) {
    const Eye eye = any_eye(chance);
    const Frustum sight = eye.frustum();
    const double depths[]{eye.near_z, eye.far_z, std::sqrt(eye.near_z) * std::sqrt(eye.far_z)};
    const double parts[]{-1, 1, 0.3};
    const Point on = eye.seen(depths[chance.pick(3)], parts[chance.pick(3)], parts[chance.pick(3)]);
    const double radius = chance.log_uniform(1e-6, 1e3) * eye.near_z;
    const Sphere sphere{on + radius * chance.direction(), radius};
    CAPTURE(seed, i);
    REQUIRE_FALSE(rejected(sight, sphere));
  }
}
