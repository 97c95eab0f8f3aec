#include "first_contact/sweep/sphere_plane.hpp"

#include "catch.hpp"
#include "oracle/plane_truth.hpp"

using namespace first_contact;
using namespace oracle;

namespace {

// The error of one sweep in units of its stated bound.
double judged(const Point& s, double r, const Vector& v, const GivenPlane& given) {
  const Sphere sphere{s, r};
  const Plane plane(given.normal, given.offset);
  const std::array<ExactVector, 1> center{exact(s)};
  return error_in_bounds(truth(s, center, r, v, given), sweep(Moving{sphere, v}, plane),
                         lengths_of(sphere, plane), v.norm());
}

}  // namespace

TEST_CASE("Sphere and plane: the error of t is within its bound, in any scene") {
  const unsigned seed = 21;
  Scenes scenes(seed);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Point s = scenes.vector(10);
    const double r = scenes.number(0, 3);
    const Vector v = scenes.vector(20);
    const GivenPlane plane{scenes.vector(scenes.length(6)), scenes.number(-5, 5)};
    CAPTURE(seed, i);
    worst = std::max(worst, judged(s, r, v, plane));
    REQUIRE(worst <= 1);
  }
  INFO("worst error: " << worst << " of the bound");
  CHECK(worst > 0);
}
TEST_CASE(
    "Sphere and plane: the error of t is within its bound far away, tiny, nearly parallel and at the ends") {
  const unsigned seed = 22;
  Scenes scenes(seed);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double unit = scenes.length(300);
    const double far = i % 2 ? 1 : scenes.length(40);
    const Point s = unit * far * scenes.vector(10);
    const double r = i % 3 ? unit * scenes.number(0, 3) : 0;
    const GivenPlane plane{scenes.vector(scenes.length(30)), unit * scenes.number(-5, 5)};
    const double t = i % 5 ? scenes.number(0, 1.1) : 1;
    const double slant = i % 7 ? scenes.number(0, 2) : scenes.length(50);
    const Vector v = scenes.motion_to(plane, s, r, t, slant);
    if (!v.allFinite()) continue;
    CAPTURE(seed, i, unit, far, slant);
    worst = std::max(worst, judged(s, r, v, plane));
    REQUIRE(worst <= 1);
  }
  INFO("worst error: " << worst << " of the bound");
  CHECK(worst > 0);
}
TEST_CASE(
    "Sphere and plane: without the term t |V| the bound would not hold for a motion that is nearly "
    "parallel") {
  // Down a slope at a shallow angle, from 2 units away: a path that is a million times as long.
  const unsigned seed = 23;
  Scenes scenes(seed);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const GivenPlane plane{scenes.vector(1), 0};
    const Point s = 2 * plane.normal.normalized();
    const Vector v = scenes.motion_to(plane, s, 1, 0.7, 1e6);
    const auto contact = sweep(Moving{Sphere{s, 1}, v}, Plane(plane.normal, plane.offset));
    const Truth t = truth(s, std::array<ExactVector, 1>{exact(s)}, 1, v, plane);
    REQUIRE(contact);
    worst = std::max(worst, error_in_bounds(t, contact, s.norm() + 1, 0));
    CHECK(error_in_bounds(t, contact, s.norm() + 1, v.norm()) <= 1);
  }
  CHECK(worst > 1000);
}
