// The ends of the range of numbers that contact.hpp promises: what is far apart in size, and what is beyond.
#include <array>
#include <cmath>

#include "catch.hpp"
#include "first_contact/geometry/bounding.hpp"
#include "first_contact/geometry/bounds.hpp"
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/motion/arc_length.hpp"
#include "first_contact/motion/bounce.hpp"
#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/motion/through_points.hpp"
#include "first_contact/motion/tween.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;

TEST_CASE("A ball of 1 from 1e300 away hits what it is aimed at, and passes what is beside its way") {
  const Moving<Sphere> from_afar{{{1e300, 0, 0}, 1}, {-2e300, 0, 0}};
  const auto hit = sweep(from_afar, Sphere{{0, 0, 0}, 1});
  REQUIRE(hit);
  CHECK(hit->time == 0.5);
  CHECK(hit->normal == Vector(1, 0, 0));
  CHECK_FALSE(sweep(from_afar, Sphere{{0, 3, 0}, 1}));
  CHECK(sweep(from_afar, Sphere{{0, 1.999, 0}, 1}));
  CHECK_FALSE(sweep(from_afar, Sphere{{0, 1e200, 0}, 1}));
  const auto on_triangle = sweep(from_afar, Triangle{{0, -1, -1}, {0, 2, -1}, {0, -1, 2}});
  REQUIRE(on_triangle);
  CHECK(on_triangle->time == Approx(0.5));
  CHECK(on_triangle->point().allFinite());
}

TEST_CASE("A floor as wide as 1e200 carries a ball of 1") {
  const Triangle floor{{-1e200, -1e200, 0}, {1e200, -1e200, 0}, {0, 1e200, 0}};
  const auto contact = sweep(Moving<Sphere>{{{0, 0, 3}, 1}, {0, 0, -4}}, floor);
  REQUIRE(contact);
  CHECK(contact->time == Approx(0.5).epsilon(1e-15));
  CHECK(contact->feature == Feature::face);
}

TEST_CASE("What is far away does not touch what is near: a mesh with one vertex at 1e250") {
  const Mesh mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1e250, 1e250, 1e250}, {1e250, 1e250, 2e250}},
                  {{0, 1, 2}, {2, 3, 4}});
  const auto contact = sweep(Moving<Sphere>{{{1, 1, 3}, 1}, {0, 0, -4}}, Environment(mesh));
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  CHECK(contact->triangle == 0);
}

TEST_CASE("A far translation is no singular transform, and undoes itself") {
  for (const double far : {1e100, 1e200, largest_length}) {
    CAPTURE(far);
    Rigid camera = Rigid::moved_by({far, -far, far}).after(Rigid::turned({1, 2, 3}, 1));
    const Transform there = camera.transform();
    CHECK_FALSE(is_singular(there.matrix()));
    CHECK((there.inverse().point(there.point(Point(far, 0, 0))) - Point(far, 0, 0)).cwiseAbs().maxCoeff() <=
          16 * far * std::numeric_limits<double>::epsilon());
  }
}

TEST_CASE("Between knots that nearly coincide a curve is fast, and has its length all the same") {
  for (const double span : {0x1p-100, 0x1p-200, 0x1p-900}) {
    CAPTURE(span);
    const BSpline bent({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}}, 1, {0, 0, span, 2 * span, 1, 1});
    CHECK(ArcLength(bent).total() == Approx(3).epsilon(1e-12));
  }
}

TEST_CASE("A slow piece with a cusp is as long behind a fast one as alone") {
  const Bezier cusp = Bezier({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}).part(0, 0.77);
  const Bezier fast({{-1, 0, 0}, {0, 0, 0}});
  for (const double span : {1e-3, 1e-6, 1e-9, 1e-12}) {
    CAPTURE(span);
    const BSpline both = joined(std::array{fast, cusp}, std::array{span, 1.0});
    CHECK(ArcLength(both).total() ==
          Approx(1 + ArcLength(cusp).total()).epsilon(4 * ArcLength::relative_error));
  }
}

TEST_CASE(
    "So late that times no longer tell the flights apart, a ball is on the floor and no faster than ever") {
  const Bounce ideal(1, 0, 9.81, 1);
  for (const double late : {1e20, 1e100, 1e308}) {
    CHECK(ideal.height(late) >= 0);
    CHECK(ideal.height(late) <= 1);
    CHECK(std::abs(ideal.speed_down(late)) <= ideal.impact(1)->speed * (1 + 1e-15));
  }
  CHECK_THROWS_AS(ideal.height(INFINITY), std::invalid_argument);
  CHECK_THROWS_AS(ideal.speed_down(NAN), std::invalid_argument);
  CHECK_FALSE(Bounce(0x1p990, 0, 0x1p-1000, 1).impact(std::size_t{1} << 63 | 1));
}

TEST_CASE("Beyond the range a bounce is refused: its numbers, and those that follow from them") {
  const double end = largest_length, beyond = std::nextafter(end, INFINITY);
  CHECK_NOTHROW(Bounce(end, 1, end, 0.5));
  CHECK_NOTHROW(Bounce(end, 0, end, 1));
  CHECK_THROWS_WITH(
      Bounce(beyond, 0, 1, 0.5),
      "bounce's height 1.07151e+301: must be finite and not negative, and at most 1.07e301 (2^1000)");
  CHECK_THROWS_WITH(Bounce(0, -beyond, 1, 0.5),
                    "bounce's speed -1.07151e+301: must be finite, and at most 1.07e301 (2^1000)");
  CHECK_THROWS_AS(Bounce(0, 0, beyond, 0.5), std::invalid_argument);
  CHECK_THROWS_WITH(Bounce(0, -1e200, 1, 0.5),
                    "height that the bounce reaches inf: must be at most 2.1e301 (2^1001)");
  CHECK_THROWS_AS(Bounce(0, 1e200, 1, 0.5), std::invalid_argument);
  CHECK_NOTHROW(Bounce(0, 1e200, 1, 0));
  CHECK_NOTHROW(Bounce(0, -1e200, 0, 0.5));
  CHECK_THROWS_WITH(Bounce(end, 0x1p-60, 0, 0.5), "bounce's time of first impact inf: must be finite");
  CHECK_THROWS_WITH(Bounce(0x1p990, 0, 0x1p-1009, 1 - 0x1p-53), "bounce's time of rest inf: must be finite");
}

TEST_CASE("Beyond the range a curve, a tween or what bounds some points is refused") {
  const double end = largest_length, beyond = std::nextafter(end, INFINITY);
  const Bezier longest({{-end, -end, 0}, {end, end, 0}});
  CHECK(longest.at(0.5) == Point(0, 0, 0));
  CHECK(ArcLength(longest).total() / end == Approx(std::sqrt(8)));
  CHECK_THROWS_WITH(
      longest.derivative(),
      "Bezier curve's derivative's control point 0 2.14302e+301, 2.14302e+301, 0: must be finite, "
      "and at most 1.07e301 (2^1000)");
  CHECK_THROWS_AS(BSpline({{-end, 0, 0}, {0, 0, 0}, {end, 0, 0}}, 2).derivative(), std::invalid_argument);
  CHECK_THROWS_AS(BSpline({{0, 0, 0}, {1, 0, 0}}, 1, {-1e308, 0, 1, 1e308}), std::invalid_argument);
  CHECK_THROWS_AS(Bezier({{beyond, 0, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(Tween({{0, {0, beyond, 0}}}), std::invalid_argument);
  CHECK_THROWS_AS(chords(longest, 0), std::invalid_argument);
  CHECK_THROWS_AS(damp(INFINITY, 0, 1, 1), std::invalid_argument);
  CHECK(damp(-1e308, 1e308, end, end) == 1e308);
  CHECK_THROWS_AS(bounding_sphere(std::vector<Point>{{-end, -end, 0}, {end, end, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(bounding_box(std::vector<Point>{{-end, -end, 0}, {end, end, 0}}), std::invalid_argument);
  CHECK(bounding_sphere(std::vector<Point>{{-end, 0, 0}, {end, 0, 0}}).radius == end);
}

TEST_CASE("Beyond the range a shape or a motion is refused when it is made, by its value and the rule") {
  const double end = largest_length, beyond = std::nextafter(end, INFINITY);
  CHECK_NOTHROW(Moving<Sphere>{{{end, -end, 0}, end}, {0, end, 0}});
  CHECK_THROWS_WITH((Sphere{{beyond, 0, 0}, 1}),
                    "sphere's centre 1.07151e+301, 0, 0: must be finite, and at most 1.07e301 (2^1000)");
  CHECK_THROWS_AS((Sphere{{0, 0, 0}, beyond}), std::invalid_argument);
  CHECK_THROWS_AS((Moving<Sphere>{{{0, 0, 0}, 1}, {0, 0, -beyond}}), std::invalid_argument);
  CHECK_THROWS_AS((Triangle{{0, 0, 0}, {0, beyond, 0}, {1, 0, 0}}), std::invalid_argument);
  CHECK_THROWS_AS((Mesh{{{0, 0, beyond}}, {}}), std::invalid_argument);
  CHECK_THROWS_AS((Box{{0, 0, 0}, {beyond, 0, 0}, {0, 1, 0}, {0, 0, 1}}), std::invalid_argument);
  CHECK_THROWS_AS((Plane{{0, 0, 1}, 1e308}), std::invalid_argument);
  CHECK_THROWS_AS(bounds_between(Point(-beyond, 0, 0), Point(0, 0, 0)), std::invalid_argument);
}
