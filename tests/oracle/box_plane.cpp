#include "first_contact/sweep/box_plane.hpp"

#include <vector>

#include "catch.hpp"
#include "first_contact/geometry/transform.hpp"
#include "oracle/plane_truth.hpp"

using namespace first_contact;
using namespace oracle;

namespace {

// The eight vertices in 50 digits.
std::vector<ExactVector> exact_vertices(const Box& box) {
  std::vector<ExactVector> vertices;
  for (int i = 0; i < 8; ++i) {
    ExactVector vertex = exact(box.center);
    for (int k = 0; k < 3; ++k) {
      const Vector& axis = k == 0 ? box.r : k == 1 ? box.s : box.t;
      const Exact half = (i >> k) & 1 ? Exact("0.5") : Exact("-0.5");
      for (int row = 0; row < 3; ++row) vertex[static_cast<std::size_t>(row)] += half * Exact(axis[row]);
    }
    vertices.push_back(vertex);
  }
  return vertices;
}

// The error of one sweep in units of its stated bound.
double judged(const Box& box, const Vector& v, const GivenPlane& given) {
  const Plane plane(given.normal, given.offset);
  return error_in_bounds(truth(box.center, exact_vertices(box), 0, v, given), sweep(Moving{box, v}, plane),
                         lengths_of(box, plane), v.norm());
}

// A box of random size that is turned at random; every third one is flat.
Box random_box(Scenes& scenes, int i, const Point& center, double unit) {
  const Rigid turn = Rigid::turned(scenes.vector(1), scenes.number(-4, 4));
  const auto side = [&](int axis, const Vector& direction) {
    const double length = i % 3 == axis && i % 2 ? 0 : unit * scenes.number(0, 4);
    return Vector(length * turn.direction(direction));
  };
  return {center, side(0, Vector::UnitX()), side(1, Vector::UnitY()), side(2, Vector::UnitZ())};
}

}  // namespace

TEST_CASE("Box and plane: the error of t is within its bound, in any scene") {
  const unsigned seed = 31;
  Scenes scenes(seed);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const Box box = random_box(scenes, i, scenes.vector(10), 1);
    const Vector v = scenes.vector(20);
    const GivenPlane plane{scenes.vector(scenes.length(6)), scenes.number(-5, 5)};
    CAPTURE(seed, i);
    worst = std::max(worst, judged(box, v, plane));
    REQUIRE(worst <= 1);
  }
  INFO("worst error: " << worst << " of the bound");
  CHECK(worst > 0);
}
TEST_CASE(
    "Box and plane: the error of t is within its bound far away, tiny, nearly parallel and at the ends") {
  const unsigned seed = 32;
  Scenes scenes(seed);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const double unit = scenes.length(300);
    const double far = i % 2 ? 1 : scenes.length(40);
    const Box box = random_box(scenes, i, unit * far * scenes.vector(10), unit);
    const GivenPlane plane{scenes.vector(scenes.length(30)), unit * scenes.number(-5, 5)};
    const double t = i % 5 ? scenes.number(0, 1.1) : 1;
    const double slant = i % 7 ? scenes.number(0, 2) : scenes.length(50);
    const double r = box.effective_radius(plane.normal.normalized());
    const Vector v = scenes.motion_to(plane, box.center, r, t, slant);
    CAPTURE(seed, i, unit, far, slant);
    worst = std::max(worst, judged(box, v, plane));
    REQUIRE(worst <= 1);
  }
  INFO("worst error: " << worst << " of the bound");
  CHECK(worst > 0);
}
TEST_CASE("Box and plane: what touches are the very vertices that are lowest in exact arithmetic") {
  const unsigned seed = 33;
  Scenes scenes(seed);
  for (int i = 0; i < 3000; ++i) {
    const Box box = random_box(scenes, 0, scenes.vector(5), 1);
    // Random normals, and normals with a box's axis nearly, but truly not, parallel to the plane.
    const Vector tilted = box.r.cross(scenes.vector(1)).normalized() + 1e-13 * box.r.normalized();
    const Vector n = (i % 2 ? scenes.vector(1) : tilted).normalized();
    const ContactPoints points = lowest_vertices(box, n);
    Exact lowest = 1e300;
    for (const ExactVector& vertex : exact_vertices(box))
      lowest = std::min<Exact>(lowest, dot(exact(n), vertex));
    CAPTURE(seed, i);
    REQUIRE(points.cols() == 1);
    CHECK(static_cast<double>(Exact(dot(exact(n), exact(points.col(0))) - lowest)) < 1e-14);
  }
}
TEST_CASE("Box and plane: stepping finely and bisecting finds the same first touch") {
  const unsigned seed = 34;
  Scenes scenes(seed);
  int touches = 0;
  for (int i = 0; i < 600; ++i) {
    const Box box = random_box(scenes, i, scenes.vector(6), 1);
    const Vector v = scenes.vector(12);
    const Plane plane(scenes.vector(1), scenes.number(-2, 2));
    const auto touching = [&](double t) {
      return overlap(Box{box.center + t * v, box.r, box.s, box.t}, plane);
    };
    if (touching(0)) continue;
    double late = 0;
    while (late <= 1 && !touching(late)) late += 1.0 / 4096;
    const auto contact = sweep(Moving{box, v}, plane);
    CAPTURE(seed, i, late);
    if (std::abs(late - 1) < 1e-3) continue;  // too near the end to step
    REQUIRE(contact.has_value() == (late <= 1));
    if (!contact) continue;
    double early = late - 1.0 / 4096;
    for (int k = 0; k < 60; ++k) (touching(0.5 * (early + late)) ? late : early) = 0.5 * (early + late);
    CHECK(contact->time == Approx(late).margin(1e-11));
    ++touches;
  }
  CHECK(touches > 100);
}
