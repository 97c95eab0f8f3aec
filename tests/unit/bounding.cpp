#include "first_contact/geometry/bounding.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "catch.hpp"
#include "first_contact/geometry/transform.hpp"

using namespace first_contact;

namespace {

using Points = std::vector<Point>;

Points corners(const Box& box) {
  const auto vertices = box.vertices();
  return {vertices.begin(), vertices.end()};
}

Points cloud(unsigned seed, std::size_t count, const Vector& size) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Points points;
  while (points.size() < count)
    points.emplace_back(
        Vector(coordinate(engine), coordinate(engine), coordinate(engine)).cwiseProduct(size));
  return points;
}

// How far the farthest point is outside the box, in units of the box's size.
double sticking_out(const Box& box, const Points& points) {
  double worst = -1;
  for (const Point& p : points)
    for (const Vector& axis : {box.r, box.s, box.t})
      if (!axis.isZero(0))
        worst = std::max(worst, std::abs((p - box.center).dot(axis)) / axis.squaredNorm() - 0.5);
  return worst;
}

const Box brick{{1, 2, 3}, {4, 0, 0}, {0, 2, 0}, {0, 0, 1}};
const Rigid turn = Rigid::moved_by({7, 8, 9}).after(Rigid::turned({1, -2, 1}, 0.8));

}  // namespace

TEST_CASE("A box of sides 4, 2 and 1 has the volume 8, turned too, and a ball of radius 3 has 36 pi") {
  CHECK(volume(brick) == 8);
  CHECK(volume(turn.box(brick)) == Approx(8));
  CHECK(volume(Sphere{{1, 2, 3}, 3}) == Approx(36 * std::numbers::pi).epsilon(1e-15));
}
TEST_CASE("The bounding box of a box along the axes is that box") {
  const Box box = bounding_box(corners(brick));
  CHECK(box.center == brick.center);
  CHECK(box.r == brick.r);
  CHECK(box.s == brick.s);
  CHECK(box.t == brick.t);
}
TEST_CASE("The bounding box of a turned box is larger, its principal box is the turned box itself") {
  const Points points = corners(turn.box(brick));
  CHECK(volume(bounding_box(points)) > 2 * volume(brick));
  CHECK(volume(principal_box(points)) == Approx(volume(brick)));
  CHECK(sticking_out(principal_box(points), points) < 1e-14);
}
TEST_CASE("Bounding boxes hold all their points, and each side touches one") {
  const Points points = cloud(5, 500, {1, 2, 7});
  for (const Box& box : {bounding_box(points), principal_box(points)}) {
    CHECK(sticking_out(box, points) < 1e-14);
    for (const Vector& axis : {box.r, box.s, box.t}) {
      double low = 0, high = 0;
      for (const Point& p : points) low = std::min(low, (p - box.center).dot(axis) / axis.squaredNorm());
      for (const Point& p : points) high = std::max(high, (p - box.center).dot(axis) / axis.squaredNorm());
      CHECK(low == Approx(-0.5));
      CHECK(high == Approx(0.5));
    }
  }
}
TEST_CASE("The bounding sphere of a box has the diagonal for its diameter") {
  const Sphere sphere = bounding_sphere(corners(turn.box(brick)));
  CHECK(sphere.center.isApprox(turn.point(brick.center)));
  CHECK(sphere.radius == Approx(std::sqrt(21.0) / 2));
}
TEST_CASE("The bounding sphere of two points is about their middle, of one point it is that point") {
  CHECK(bounding_sphere(Points{{0, 0, 0}, {2, 0, 0}}).center.isApprox(Point(1, 0, 0)));
  CHECK(bounding_sphere(Points{{0, 0, 0}, {2, 0, 0}}).radius == Approx(1));
  CHECK(bounding_sphere(Points{{4, 5, 6}}).center == Point(4, 5, 6));
  CHECK(bounding_sphere(Points{{4, 5, 6}}).radius == 0);
}
TEST_CASE(
    "Of an obtuse triangle the longest side is the diameter, of an acute one all corners are on the rim") {
  CHECK(bounding_sphere(Points{{-2, 0, 0}, {2, 0, 0}, {0, 1, 0}}).radius == Approx(2));
  const double h = std::sqrt(3.0);
  CHECK(bounding_sphere(Points{{-1, 0, 0}, {1, 0, 0}, {0, h, 0}}).radius == Approx(2 / h));
}
TEST_CASE(
    "No point is outside its bounding sphere, and none smaller holds them: its rim surrounds the centre") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const Points points = cloud(seed, 5 + 25 * seed, {1, 1 + 0.1 * seed, seed % 3 ? 1.0 : 0.0});
    const Sphere sphere = bounding_sphere(points);
    for (const Point& p : points) REQUIRE((p - sphere.center).norm() <= sphere.radius);
    // Move the centre anywhere by a little: some point then is farther away than the radius.
    for (const Point& step : cloud(seed + 100, 100, {1, 1, 1})) {
      double farthest = 0;
      for (const Point& p : points)
        farthest = std::max(farthest, (p - sphere.center - 1e-3 * step.normalized()).norm());
      REQUIRE(farthest > sphere.radius * (1 - 1e-9));
    }
  }
}
TEST_CASE("Points that are equal, on one line, in one plane or on one sphere have a bounding sphere too") {
  CHECK(bounding_sphere(Points(50, Point(1, 2, 3))).radius == 0);
  Points line, grid, ball;
  for (int i = 0; i <= 100; ++i) line.emplace_back(Point(1, 2, 3) + i * Vector(0.03, 0.04, 0));
  for (int i = 0; i <= 10; ++i)
    for (int k = 0; k <= 10; ++k) {
      grid.emplace_back(i, k, 0.1 * i + 0.2 * k);
      const double a = 0.6 * i, b = std::numbers::pi * k / 10;
      ball.emplace_back(std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b));
    }
  CHECK(bounding_sphere(line).radius == Approx(2.5));
  CHECK(bounding_sphere(grid).radius == Approx(std::sqrt(100 + 100 + 9) / 2));
  CHECK(bounding_sphere(ball).radius == Approx(1));
}
TEST_CASE("Four points a little out of one plane are all on the rim, and four of one circle do no harm") {
  // Two above the circle of radius 1, two below it, by d: their sphere is sqrt(1 + d^2) large. The sphere of
  // three of them would be too large by 3.5 d^2 if the fourth only pushed it.
  for (const double d : {1e-2, 1e-3, 1e-4, 1e-5, 1e-9, 1e-13, 0.0}) {
    CAPTURE(d);
    const Points points{{1, 0, d}, {-1, 0, d}, {0, 1, -d}, {0, -1, -d}};
    for (const Rigid& place : {Rigid(), turn}) {
      Points moved;
      for (const Point& p : points) moved.push_back(place.point(p));
      const double smallest = std::sqrt(1 + d * d);
      CHECK(std::abs(bounding_sphere(moved).radius - smallest) <= 1e-9 * smallest);
    }
  }
}
TEST_CASE("The bounding sphere of very many points of one circle is the circle's") {
  for (const double tilt : {0.0, 0.3, 1.2}) {
    Points points;
    const Rigid place = Rigid::moved_by({100, -50, 3}).after(Rigid::turned({1, 2, 0.5}, tilt));
    for (int i = 0; i < 1000; ++i) points.push_back(place.point({std::cos(i), std::sin(i), 0}));
    CAPTURE(tilt);
    CHECK(bounding_sphere(points).radius == Approx(1).epsilon(1e-9));
  }
}
TEST_CASE("Points of one sphere, however many, do not push each other off its rim") {
  Points ball = cloud(
      1, 20000, {1, 1, 1});  // to go through all four of them that are said to stick out would take for ever
  for (Point& p : ball) p.normalize();
  CHECK(bounding_sphere(ball).radius == Approx(1).epsilon(1e-9));
}
TEST_CASE("Far from the origin a bounding sphere is too large by 2 eps of its largest coordinate at most") {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  for (const double far : {1.0, 1e4, 1e8, 1e12, 1e16, 1e100})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      Points points = cloud(seed, 30, {1, 1, 1});
      for (Point& p : points) p += Vector(far, -far / 3, far / 7);
      Points nearby;  // the same points, seen from the first: exact
      for (const Point& p : points) nearby.emplace_back(p - points.front());
      const Sphere sphere = bounding_sphere(points);
      CAPTURE(far, seed);
      CHECK(sphere.radius <= (1 + 1e-9) * bounding_sphere(nearby).radius + 2 * eps * (far + 1));
      for (const Point& p : points) CHECK((p - sphere.center).norm() <= sphere.radius);
    }
}
TEST_CASE("Bounding shapes of points from 1e-320 to 1e300 apart are those of the same points at size 1") {
  const Points points = cloud(9, 100, {3, 2, 1});
  for (const int exponent : {-1050, -1000, -600, -300, 300, 600, 990}) {
    CAPTURE(exponent);
    Points scaled;
    for (const Point& p : points)
      scaled.emplace_back(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                          std::ldexp(p.z(), exponent));
    const double rounding = exponent < -900 ? std::ldexp(1, -1070 - exponent) : 1e-14;
    const auto at_size_1 = [&](double length) { return std::ldexp(length, -exponent); };
    CHECK(at_size_1(bounding_sphere(scaled).radius) ==
          Approx(bounding_sphere(points).radius).epsilon(1e-9 + rounding));
    CHECK(at_size_1(principal_box(scaled).r.stableNorm()) ==
          Approx(principal_box(points).r.norm()).epsilon(1e-9 + rounding));
  }
}
TEST_CASE("A bounding sphere does not depend on how large the points' unit is") {
  const Points points = cloud(9, 200, {3, 2, 1});
  Points tiny = points;
  for (Point& p : tiny) p *= std::ldexp(1, -300);
  CHECK(bounding_sphere(tiny).radius == std::ldexp(bounding_sphere(points).radius, -300));
}
TEST_CASE("A bounding shape of nothing, or of a point that is not finite, is refused") {
  const Points bad{{0, 0, 0}, {0, std::nan(""), 0}};
  CHECK_THROWS_AS(bounding_box(Points{}), std::invalid_argument);
  CHECK_THROWS_AS(bounding_sphere(Points{}), std::invalid_argument);
  CHECK_THROWS_AS(principal_box(bad), std::invalid_argument);
  CHECK_THROWS_AS(bounding_sphere(bad), std::invalid_argument);
}
