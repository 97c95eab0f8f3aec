#include "first_contact/motion/sweep_along.hpp"

#include <limits>

#include "catch.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;

namespace {

const Plane ground{{0, 0, 1}, 0};
const Bezier dive({{0, 0, 4}, {2, 0, -4}, {4, 0, 4}});  // z = 4 (1 - 4 u (1 - u)): down to 0 at u = 1/2

}  // namespace

TEST_CASE("Along a line there is one chord, and the contact is that of the plain sweep") {
  CHECK(chords(line({0, 0, 3}, {1, 0, -1}), 1e-9) == std::vector<double>{0, 1});
  const auto touch = sweep_along(line({0, 0, 3}, {0, 0, -1}), 1, ground, 1e-9);
  REQUIRE(touch);
  CHECK(touch->time == 0.5);
  CHECK(touch->normal == Vector(0, 0, 1));
}

TEST_CASE("Along a curve a sphere meets the plane where its true height is its radius") {
  // 4 (1 - 2u)^2 = 1 at u = 1/4, where the height falls by 8 a unit of u.
  const double gap = 1e-6;
  const auto touch = sweep_along(dive, 1, ground, gap);
  REQUIRE(touch);
  CHECK(touch->time <= 0.25);
  CHECK(touch->time >= 0.25 - 1.01 * gap / 8);
  CHECK(std::abs(touch->point().x() - 1) <= 1e-6);
}

TEST_CASE("The ends alone would miss it: both are far from the plane") {
  CHECK_FALSE(sweep(Moving<Sphere>{{dive.at(0), 1}, dive.at(1) - dive.at(0)}, ground));
  CHECK(sweep_along(dive, 1, ground, 0.1));
}

TEST_CASE(
    "No chord is further from the curve than the deviation, at every u, and the bound is not wasteful") {
  const Curve curves[]{Bezier({{0, 0, 0}, {0, 4, 0}, {3, 4, 1}, {3, 0, 0}}),
                       BSpline({{0, 0, 0}, {1, 3, 0}, {3, 3, 1}, {4, -2, 2}, {6, 0, 0}, {7, 7, 7}}, 3),
                       BSpline({{0, 0, 0}, {1, 3, 0}, {3, 3, 1}, {4, -2, 2}}, 1)};
  for (const Curve& curve : curves)
    for (const double deviation : {0.5, 0.01, 1e-4}) {
      const auto u = chords(curve, deviation);
      double worst = 0;
      for (std::size_t i = 1; i < u.size(); ++i)
        for (const double s : {0.25, 0.5, 0.75}) {
          const Point chord = (1 - s) * at(curve, u[i - 1]) + s * at(curve, u[i]);
          worst = std::max(worst, (chord - at(curve, std::lerp(u[i - 1], u[i], s))).norm());
        }
      CHECK(worst <= deviation * (1 + 1e-9));
      if (deviation < 1e-3 && curve.index() == 0) CHECK(worst > 0.5 * deviation);
    }
}

TEST_CASE(
    "A parabola is off its chord by n (n - 1) / 8 of its second difference: by 1/4, as it is in its middle") {
  const Bezier parabola({{0, 0, 0}, {1, 0, 2}, {2, 0, 0}});
  CHECK(deviation_of_chord(parabola) == 1);
  CHECK(parabola.at(0.5) == Point(1, 0, 1));
  CHECK(deviation_of_chord(Bezier({{0, 0, 0}, {1, 0, 2}, {2, 0, 0}, {3, 0, 2}})) == 3);
}

TEST_CASE("A corner of a B-spline is a joint of the chords") {
  const BSpline polyline({{0, 0, 5}, {1, 0, 0.5}, {2, 0, 5}}, 1);
  CHECK(chords(polyline, 1e-3) == std::vector<double>{0, 0.5, 1});
  CHECK(sweep_along(polyline, 0.75, ground, 1e-3)->time < 0.5);
}

TEST_CASE("A sphere that overlaps at the start and leaves has no contact, until it comes back") {
  const Bezier hop({{0, 0, 0.5}, {1, 0, 6}, {2, 0, 0.5}});
  const auto touch = sweep_along(hop, 1, ground, 1e-6);
  REQUIRE(touch);
  CHECK(touch->time > 0.5);
}

TEST_CASE("What the curve grazes is met, though every chord's own sphere would pass it by") {
  // The lowest place of the dive is at height 0: a plane that a ball of radius 1 grazes there.
  for (const double off : {-1e-3, -1e-6, 0.0})
    for (const double gap : {0.5, 0.01, 1e-7}) {
      const auto touch = sweep_along(dive, 1, Plane({0, 0, 1}, 1 + off), gap);
      REQUIRE(touch);
      CHECK(touch->time <= 0.5);
      CHECK(dive.at(touch->time).z() - 1 <= -1 - off + gap);
    }
  CHECK_FALSE(sweep_along(dive, 1, Plane({0, 0, 1}, 1 + 1.01e-6), 1e-6));
}

TEST_CASE(
    "A curve that begins and ends on the floor and dips into it between is stopped at once, and an arch when "
    "it lands") {
  const Bezier sag({{0, 0, 1}, {1, 0, 0.5}, {2, 0, 1}}), arch({{0, 0, 1}, {1, 0, 1.5}, {2, 0, 1}});
  const auto touch = sweep_along(sag, 1, ground, 1e-6);
  REQUIRE(touch);
  CHECK(touch->time <= 1e-5);
  const auto landing = sweep_along(arch, 1, ground, 1e-6);
  REQUIRE(landing);
  CHECK(landing->time >= 1 - 2e-6);
}

TEST_CASE(
    "What glides along a floor meets the wall in front, and not the floor, though rounding leads it in and "
    "out") {
  const Triangle wall{{3, -9, -9}, {3, 9, -9}, {3, 0, 20}};
  const Vector up = Vector(1, 2, 30).normalized();
  const auto floor_and_wall = [&](const Moving<Sphere>& ball) {
    const auto floor = sweep(ball, Plane(up, 0)), other = sweep(ball, wall);
    return !floor || (other && other->time < floor->time) ? other : floor;
  };
  const Vector across = up.cross(Vector(1, 0, 0)).normalized(), along = across.cross(up);
  std::vector<Point> points;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 2.0}, {2.0, -3.0}, {5.0, 0.0}})
    points.emplace_back(x * along + y * across + 0.5 * up);
  const Bezier on_the_floor(points);
  const auto touch = sweep_along(on_the_floor, 0.5, floor_and_wall, 9, 1e-7);
  REQUIRE(touch);
  CHECK(touch->normal == Vector(-1, 0, 0));
  CHECK(on_the_floor.at(touch->time).x() == Approx(2.5).margin(1e-6));
}

TEST_CASE("A closed curve is swept all round, though its chord is a point") {
  const Bezier loop({{0, 0, 4}, {6, 0, -6}, {-6, 0, -6}, {0, 0, 4}});
  const auto touch = sweep_along(loop, 1, ground, 1e-6);
  REQUIRE(touch);
  CHECK(loop.at(touch->time).z() == Approx(1).margin(1e-6));
}

TEST_CASE(
    "A deviation that is zero, negative, not a number or absurdly small is refused, and so is such a gap") {
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  for (const double deviation : {0.0, -1.0, no_number, 1e-30}) {
    CHECK_THROWS_AS(chords(dive, deviation), std::invalid_argument);
    CHECK_THROWS_AS(sweep_along(dive, 1, ground, deviation), std::invalid_argument);
  }
  CHECK_THROWS_WITH(sweep_along(dive, 1, ground, 1e-30),
                    "gap 1e-30: must be at least 2^-32 of the scene's size, 4");
  CHECK_THROWS_AS(sweep_along(dive, -1, ground, 0.1), std::invalid_argument);
}
