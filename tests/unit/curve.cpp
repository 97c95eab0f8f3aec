#include "first_contact/motion/curve.hpp"

#include <limits>

#include "catch.hpp"

using namespace first_contact;

namespace {

const std::vector<Point> five{{0, 0, 0}, {1, 3, 0}, {3, 3, 1}, {4, -2, 2}, {6, 0.7, 0.1}};

void check_near(const Point& a, const Point& b, double tolerance = 1e-14) {
  CAPTURE(a.transpose(), b.transpose());
  CHECK((a - b).norm() <= tolerance * (1 + b.norm()));
}

}  // namespace

TEST_CASE("A line is straight, at constant speed, and ends exactly at its ends") {
  const Bezier l = line({0.1, 0.2, 0.3}, {0.7, -1, 3.3});
  CHECK(l.at(0) == Point(0.1, 0.2, 0.3));
  CHECK(l.at(1) == Point(0.7, -1, 3.3));
  check_near(l.at(0.5), {0.4, -0.4, 1.8});
  CHECK(l.derivative().at(0.3) == l.derivative().at(0.9));
}

TEST_CASE("A Bezier curve is Bernstein's sum") {
  const Bezier curve(five);
  for (const double u : {0.125, 0.5, 0.9}) {
    const double v = 1 - u;
    check_near(curve.at(u), v * v * v * v * five[0] + 4 * u * v * v * v * five[1] +
                                6 * u * u * v * v * five[2] + 4 * u * u * u * v * five[3] +
                                u * u * u * u * five[4]);
  }
}

TEST_CASE("Curves begin and end exactly at their first and last control points") {
  const Curve curves[]{Bezier(five), BSpline(five, 1), BSpline(five, 2), BSpline(five, 3), BSpline(five, 4)};
  for (const Curve& curve : curves) {
    CHECK(at(curve, 0) == five.front());
    CHECK(at(curve, 1) == five.back());
  }
}

TEST_CASE("An unclamped B-spline misses its end points") {
  const BSpline loose(five, 3, {0, 1, 2, 3, 4, 5, 6, 7, 8});
  CHECK((loose.at(0) - five.front()).norm() > 1);
  CHECK((loose.at(1) - five.back()).norm() > 1);
  check_near(loose.at(0), (five[0] + 4 * five[1] + five[2]) / 6);  // the uniform cubic's first point
}

TEST_CASE("A clamped B-spline with one piece is a Bezier curve") {
  const Bezier bezier(five);
  const BSpline spline(five, 4);
  for (double u = 0; u <= 1; u += 0.0625) check_near(spline.at(u), bezier.at(u));
}

TEST_CASE("A B-spline of degree 1 goes straight from control point to control point") {
  const BSpline polyline(five, 1);
  check_near(polyline.at(0.25), five[1]);
  check_near(polyline.at(0.375), 0.5 * (five[1] + five[2]));
  CHECK(polyline.breaks() == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
}

TEST_CASE("Moving one control point bends a B-spline only nearby") {
  std::vector<Point> points;
  for (int i = 0; i < 12; ++i) points.emplace_back(i, i % 3, 0);
  const BSpline before(points, 3);
  points[2] += Vector(0, 5, 0);
  const BSpline after(points, 3);
  CHECK(before.at(0.2) != after.at(0.2));
  for (double u = 3.0 / 9; u <= 1; u += 0.01) CHECK(before.at(u) == after.at(u));
}

TEST_CASE(
    "The parameter runs over [0, 1] whatever the knots, and shifted or stretched knots give the same curve") {
  const BSpline plain(five, 2, {0, 0, 0, 1, 3, 4, 4, 4});
  const BSpline other(five, 2, {16, 16, 16, 18, 22, 24, 24, 24});
  for (double u = 0; u <= 1; u += 0.03125) CHECK(plain.at(u) == other.at(u));
  CHECK(plain.breaks() == std::vector<double>{0, 0.25, 0.75, 1});
}

TEST_CASE("A curve of degree 0 is a point, and its derivative is zero") {
  CHECK(Bezier({{1, 2, 3}}).at(0.3) == Point(1, 2, 3));
  CHECK(Bezier({{1, 2, 3}}).derivative().at(0.3) == Vector(0, 0, 0));
  CHECK(BSpline({{1, 2, 3}}, 0).at(1) == Point(1, 2, 3));
  CHECK(BSpline({{1, 2, 3}}, 0).derivative().at(0.3) == Vector(0, 0, 0));
}

TEST_CASE("A knot that coincides as often as the degree makes a corner, through the control point") {
  const BSpline corner(five, 2, {0, 0, 0, 0.5, 0.5, 1, 1, 1});
  check_near(corner.at(0.5), five[2]);
  const BSpline slope = corner.derivative();
  check_near(slope.at(0.5), 4 * (five[3] - five[2]));
  check_near(slope.at(0.5 - 1e-14), 4 * (five[2] - five[1]), 1e-12);
  CHECK(slope.derivative().at(0.25).allFinite());
}

TEST_CASE("Outside [0, 1] a curve goes on as its polynomial, for easings that overshoot") {
  check_near(line({0, 0, 0}, {2, 4, 6}).at(-0.5), {-1, -2, -3});
  check_near(BSpline({{0, 0, 0}, {2, 4, 6}}, 1).at(1.5), {3, 6, 9});
  check_near(BSpline(five, 4).at(-0.25), Bezier(five).at(-0.25));
}

TEST_CASE("Curves without control points, with too few, or with one that is not finite are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(Bezier({}), std::invalid_argument);
  CHECK_THROWS_AS(Bezier({{0, 0, 0}, {nan, 0, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(BSpline({}, 0), std::invalid_argument);
  CHECK_THROWS_AS(BSpline(five, 5), std::invalid_argument);
  for (const std::size_t degree : {std::size_t{100'000'000'000}, std::numeric_limits<std::size_t>::max()})
    CHECK_THROWS_WITH(BSpline(five, degree),
                      "B-spline's 5 control points: must be more than the degree, " + std::to_string(degree));
  CHECK_THROWS_AS(BSpline({{0, 0, 0}, {nan, 0, 0}}, 1), std::invalid_argument);
  for (const Curve& curve : {Curve(Bezier(five)), Curve(BSpline(five, 2))})
    CHECK_THROWS_AS(scaled(curve, nan), std::invalid_argument);
}

TEST_CASE("Knots that are too few, descending, not finite, all equal or too often the same are refused") {
  const auto knots = [](std::vector<double> values) { return BSpline(five, 2, std::move(values)); };
  CHECK_NOTHROW(knots({0, 0, 0, 1, 2, 3, 3, 3}));
  CHECK_THROWS_AS(knots({0, 0, 0, 1, 2, 3, 3}), std::invalid_argument);
  CHECK_THROWS_WITH(knots({0, 0, 0, 2, 1, 3, 3, 3}),
                    "B-spline's knot 4, 1: must not be less than the one before");
  CHECK_THROWS_WITH(knots({0, 0, 0, 1, 2, 3, 3, std::numeric_limits<double>::infinity()}),
                    "B-spline's knot 7, inf: must be finite");
  CHECK_THROWS_AS(knots({1, 1, 1, 1, 1, 1, 1, 1}), std::invalid_argument);
  CHECK_THROWS_WITH(BSpline({{1, 2, 3}}, 0, {1, 1}),
                    "B-spline's knots from 1 to 1: must span a finite interval");
  CHECK_THROWS_AS(knots({0, 0, 1, 1, 1, 3, 3, 3}), std::invalid_argument);
}
