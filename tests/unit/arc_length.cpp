#include "first_contact/motion/arc_length.hpp"

#include <cmath>

#include "catch.hpp"

using namespace first_contact;

namespace {

const Bezier arch({{0, 0, 0}, {0, 4, 0}, {3, 4, 0}, {3, 0, 0}});

}  // namespace

TEST_CASE("The length of a line is the distance of its ends") {
  const ArcLength length(line({1, 2, 3}, {3, 5, 9}));
  CHECK(length.total() == Approx(7).epsilon(ArcLength::relative_error));
  CHECK(length.to(0.25) == Approx(1.75).epsilon(1e-12));
}

TEST_CASE("The length of a parabola is its closed form") {
  // y = x^2 from 0 to 1: sqrt(5)/2 + asinh(2)/4.
  const ArcLength length(Bezier({{0, 0, 0}, {0.5, 0, 0}, {1, 1, 0}}));
  const auto closed = [](double x) { return x * std::sqrt(1 + 4 * x * x) / 2 + std::asinh(2 * x) / 4; };
  CHECK(std::abs(length.total() - closed(1)) <= ArcLength::relative_error * closed(1));
  for (const double x : {0.1, 0.35, 0.8})
    CHECK(std::abs(length.to(x) - closed(x)) <= ArcLength::relative_error * closed(1));
}

TEST_CASE("The length of a semicubical cusp is its closed form") {
  // (u^2, u^3) for u from -1 to 1 has a cusp in the middle; each half is (13^(3/2) - 8) / 27 long.
  const ArcLength length(Bezier({{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}}));
  const double closed = 2 * (std::pow(13.0, 1.5) - 8) / 27;
  CHECK(std::abs(length.total() - closed) <= ArcLength::relative_error * closed);
}

TEST_CASE("A curve that turns back on itself is measured to and fro") {
  const ArcLength length(Bezier({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}));  // out to 1/2 and back
  CHECK(std::abs(length.total() - 1) <= ArcLength::relative_error);
  CHECK(length.at(0.5).x() == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("A B-spline of degree 1 is as long as its control polygon") {
  const ArcLength length(BSpline({{0, 0, 0}, {3, 4, 0}, {3, 4, 12}, {0, 0, 12}}, 1));
  CHECK(std::abs(length.total() - 22) <= 22 * ArcLength::relative_error);
  CHECK((length.at(17.0 / 22) - Point(3, 4, 12)).norm() < 1e-10);
}

TEST_CASE("Length and parameter undo each other, and the ends are exact") {
  const ArcLength length(arch);
  CHECK(length.to(0) == 0);
  CHECK(length.to(1) == length.total());
  CHECK(length.parameter(0) == 0);
  CHECK(length.parameter(length.total()) == 1);
  CHECK(length.parameter(-1) == 0);
  CHECK(length.parameter(2 * length.total()) == 1);
  for (double u = 0.01; u < 1; u += 0.01) CHECK(length.parameter(length.to(u)) == Approx(u).epsilon(1e-10));
}

TEST_CASE("By arc length a curve is gone along at constant speed, by its parameter it is not") {
  const ArcLength length(arch);
  double slowest = 1e300, fastest = 0;
  const int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    const double step = (length.at((i + 1.0) / steps) - length.at(static_cast<double>(i) / steps)).norm();
    CHECK(step == Approx(length.total() / steps).epsilon(1e-4));
    const double naive = (arch.at((i + 1.0) / steps) - arch.at(static_cast<double>(i) / steps)).norm();
    slowest = std::min(slowest, naive);
    fastest = std::max(fastest, naive);
  }
  CHECK(fastest / slowest > 1.5);
}

TEST_CASE("Ends are hit exactly by arc length, and beyond them it goes straight on") {
  const ArcLength length(arch);
  CHECK(length.at(0) == Point(0, 0, 0));
  CHECK(length.at(1) == Point(3, 0, 0));
  CHECK((length.at(1.1) - Point(3, -0.1 * length.total(), 0)).norm() < 1e-12);
  CHECK((length.at(-0.1) - Point(0, -0.1 * length.total(), 0)).norm() < 1e-12);
}

TEST_CASE(
    "Where its end points are there twice, a curve goes straight on from the next other control point") {
  const ArcLength length(Bezier({{0, 0, 0}, {0, 0, 0}, {0, 2, 0}, {1, 3, 0}, {4, 3, 0}, {4, 3, 0}}));
  CHECK((length.at(1.5) - Point(4 + 0.5 * length.total(), 3, 0)).norm() < 1e-12);
  CHECK((length.at(-0.5) - Point(0, -0.5 * length.total(), 0)).norm() < 1e-12);
}

TEST_CASE("A curve of no length stays where it is") {
  const ArcLength length(Bezier({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
  CHECK(length.total() == 0);
  CHECK(length.at(0.5) == Point(1, 2, 3));
}

TEST_CASE("A curve scaled by a power of two has its length scaled by it, to the last bit") {
  std::vector<Point> large;
  for (const Point& p : arch.control_points()) large.emplace_back(1048576 * p);
  CHECK(ArcLength(Bezier(large)).total() == 1048576 * ArcLength(arch).total());
}
