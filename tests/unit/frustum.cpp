#include "first_contact/geometry/frustum.hpp"

#include <numbers>
#include <random>

#include "catch.hpp"

using namespace first_contact;

namespace {

const Transform eye = Transform::perspective(std::numbers::pi / 2, 1, 1, 10);
const Frustum sight(eye);

bool in_view(const Frustum& frustum, const Point& p) {
  for (const Plane& e : frustum.planes)
    if (e.signed_distance(p) < 0) return false;
  return true;
}

Box cube_at(const Point& center, double side = 2) {
  return {center, {side, 0, 0}, {0, side, 0}, {0, 0, side}};
}

struct Dice {
  explicit Dice(unsigned seed) : engine(seed) {}
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vector vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
  Box box(double size) {
    const Rigid turn = Rigid::turned(vector(1), (*this)(0, 6));
    return turn.box(
        {vector(12), {(*this)(0, size), 0, 0}, {0, (*this)(0, size), 0}, {0, 0, (*this)(0, size)}});
  }
  std::mt19937 engine;
};

}  // namespace

TEST_CASE("The six planes of a frustum face inwards") {
  for (const Plane& e : sight.planes) CHECK(e.signed_distance({0, 0, -5}) > 0);
  CHECK(sight.planes[4].signed_distance({7, 8, -1}) == Approx(0).margin(1e-14));   // near
  CHECK(sight.planes[5].signed_distance({7, 8, -10}) == Approx(0).margin(1e-14));  // far
}
TEST_CASE("The planes of a frustum are the faces of the cube, brought back by the inverse projection") {
  const Plane left_of_cube({1, 0, 0}, 1);
  CHECK(eye.inverse().plane(left_of_cube).coefficients().isApprox(sight.planes[0].coefficients()));
}
TEST_CASE("A point is on the inner side of all six planes just when its image is in the cube") {
  const unsigned seed = 2;
  CAPTURE(seed);
  Dice dice(seed);
  for (int i = 0; i < 10000; ++i) {
    const Point p = dice.vector(12);
    const Homogeneous image = eye.apply(as_point(p));
    const double margin = image.w() - image.head<3>().cwiseAbs().maxCoeff();
    CAPTURE(p.transpose());
    if (std::abs(margin) > 1e-12) CHECK(in_view(sight, p) == (margin > 0));
  }
}
TEST_CASE("A box behind, beside, before or beyond what the eye sees is rejected") {
  CHECK(rejected(sight, cube_at({0, 0, 5})));
  CHECK(rejected(sight, cube_at({9, 0, -5})));
  CHECK(rejected(sight, cube_at({0, -9, -5})));
  CHECK(rejected(sight, cube_at({0, 0, -12})));
  CHECK_FALSE(rejected(sight, cube_at({0, 0, -5})));
}
TEST_CASE("A box is rejected from E.Q < -r_eff on, and kept while it touches") {
  CHECK_FALSE(rejected(sight, cube_at({0, 0, -10.9999})));
  CHECK(rejected(sight, cube_at({0, 0, -11.0001})));
}
TEST_CASE("A sphere is rejected from E.S < -r on, and kept while it touches") {
  CHECK_FALSE(rejected(sight, Sphere{{0, 0, -10.9999}, 1}));
  CHECK(rejected(sight, Sphere{{0, 0, -11.0001}, 1}));
  CHECK(rejected(sight, Sphere{{0, 0, 3}, 3.9}));
}
TEST_CASE("The frustum of a camera that moves is the moved frustum") {
  const Rigid camera = Rigid::moved_by({5, 6, 7}).after(Rigid::turned({1, 1, 0}, 1.1));
  const Frustum moved(eye.after(camera.inverse().transform()));
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(moved.planes[i].coefficients().isApprox(camera.plane(sight.planes[i]).coefficients()));
}
TEST_CASE(
    "Nothing that is in view is ever rejected: of a rejected shape, every sampled point is out of view") {
  const unsigned seed = 3;
  CAPTURE(seed);
  Dice dice(seed);
  int rejections = 0;
  for (int i = 0; i < 2000; ++i) {
    const Box box = dice.box(8);
    const Sphere sphere{box.center, dice(0, 5)};
    const bool no_box = rejected(sight, box);
    const bool no_sphere = rejected(sight, sphere);
    rejections += no_box + no_sphere;
    for (int k = 0; k < 40; ++k) {
      const Vector a = dice.vector(0.5);
      const Point in_box = box.center + a.x() * box.r + a.y() * box.s + a.z() * box.t;
      const Point in_sphere = sphere.center + sphere.radius * dice(0, 1) * a.normalized();
      if (no_box && in_view(sight, in_box)) FAIL("a box in view was rejected at " << box.center.transpose());
      if (no_sphere && in_view(sight, in_sphere))
        FAIL("a sphere in view was rejected at " << box.center.transpose());
    }
  }
  CHECK(rejections > 1000);
}
TEST_CASE(
    "Rejection is cautious: a box off an edge of the frustum is behind no single plane, and is kept unseen") {
  // Across the left lower edge of sight, which runs along (-1, -1, -1), lies a long box, slantwise and
  // outside.
  const Vector out = Vector(-1, -1, 1).normalized();
  const Vector across = Vector(1, -1, 0).normalized();
  const Box unseen{Point(-5, -5, -5) + 0.6 * out, 12 * across, 0.2 * out, 0.2 * out.cross(across)};
  CHECK_FALSE(rejected(sight, unseen));
  for (int k = -50; k <= 50; ++k)
    for (const double side : {-0.5, 0.5})
      CHECK_FALSE(in_view(sight, unseen.center + k / 100.0 * unseen.r + side * unseen.s));
}
