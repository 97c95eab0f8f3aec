#include "first_contact/motion/through_points.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "chance.hpp"

using namespace first_contact;

namespace {

constexpr Knots every_knots[]{Knots::uniform, Knots::centripetal, Knots::chordal};

// Barry and Goldman's pyramid (1988) of straight tweens, for the leg from b to c: another way to the same curve.
Point pyramid(const Point& a, const Point& b, const Point& c, const Point& d, double power, double part) {
  const auto after = [&](double knot, const Point& p, const Point& q) {
    return knot + std::pow((q - p).norm(), power);
  };
  const double ta = 0, tb = after(ta, a, b), tc = after(tb, b, c), td = after(tc, c, d);
  const double t = tb + part * (tc - tb);
  const auto mix = [t](const Point& p, double from, const Point& q, double to) {
    return Point(((to - t) * p + (t - from) * q) / (to - from));
  };
  const Point ab = mix(a, ta, b, tb), bc = mix(b, tb, c, tc), cd = mix(c, tc, d, td);
  return mix(mix(ab, ta, bc, tc), tb, mix(bc, tb, cd, td), tc);
}

std::vector<Point> zigzag() { return {{0, 0, 0}, {1, 2, 0}, {1.25, 2, 1}, {5, -1, 0}, {6, 0, 3}}; }

// Do two of a hundred chords of a curve in the plane cross each other?
bool crosses_itself(const Bezier& curve) {
  constexpr int chords = 100;
  const auto side = [](const Point& a, const Point& b, const Point& c) {
    return (b - a).cross(c - a).z() > 0;
  };
  std::vector<Point> p;
  for (int i = 0; i <= chords; ++i) p.push_back(curve.at(i / double(chords)));
  for (std::size_t i = 0; i < chords; ++i)
    for (std::size_t k = i + 2; k < chords; ++k)
      if (side(p[i], p[i + 1], p[k]) != side(p[i], p[i + 1], p[k + 1]) &&
          side(p[k], p[k + 1], p[i]) != side(p[k], p[k + 1], p[i + 1]))
        return true;
  return false;
}

bool is_near(const Point& p, const Point& q, double rounding = 1e-13) { return (p - q).norm() <= rounding; }

}  // namespace

TEST_CASE("A Hermite curve has the ends and the velocities that it was given, and the values of its basis") {
  const Point a(1, 2, 3), b(-1, 0, 4);
  const Vector m(3, 0, 6), n(0, -3, 3);
  const Bezier curve = hermite(a, m, b, n);
  CHECK(curve.at(0) == a);
  CHECK(curve.at(1) == b);
  CHECK(is_near(curve.derivative().at(0), m));
  CHECK(is_near(curve.derivative().at(1), n));
  // At u = 1/4 the basis is 54/64, 9/64, 10/64, -3/64.
  CHECK(is_near(curve.at(0.25), (54 * a + 9 * m + 10 * b - 3 * n) / 64));
}

TEST_CASE("In the middle of a uniform leg its two points count 9/16, and their neighbours -1/16") {
  const auto p = zigzag();
  CHECK(is_near(catmull_rom(p, Knots::uniform).at(3.0 / 8), (-p[0] + 9 * p[1] + 9 * p[2] - p[3]) / 16));
}

TEST_CASE("A curve through points is Barry and Goldman's pyramid, whatever its knots") {
  const auto p = zigzag();
  for (const auto& [knots, power] :
       {std::pair(Knots::uniform, 0.0), {Knots::centripetal, 0.5}, {Knots::chordal, 1.0}}) {
    const auto legs = catmull_rom_legs(p, knots);
    for (const double part : {0.0, 0.125, 0.5, 0.9, 1.0}) {
      CHECK(is_near(legs[1].at(part), pyramid(p[0], p[1], p[2], p[3], power, part)));
      CHECK(is_near(legs[2].at(part), pyramid(p[1], p[2], p[3], p[4], power, part)));
      CHECK(is_near(legs[0].at(part), pyramid(2 * p[0] - p[1], p[0], p[1], p[2], power, part)));
    }
  }
}

TEST_CASE("It goes through each of its points, exactly, in order, and without a corner") {
  const auto p = zigzag();
  for (const Knots knots : every_knots) {
    const BSpline curve = catmull_rom(p, knots);
    const auto joints = curve.breaks();
    REQUIRE(joints.size() == p.size());
    for (std::size_t i = 0; i < p.size(); ++i) CHECK(is_near(curve.at(joints[i]), p[i]));
    CHECK(curve.at(0) == p.front());
    CHECK(curve.at(1) == p.back());
    const auto pieces = curve.derivative().pieces();
    for (std::size_t i = 1; i < pieces.size(); ++i)
      CHECK(is_near(pieces[i].at(0), pieces[i - 1].at(1), 1e-12));
  }
}

TEST_CASE("Through two points it is a line, and points on a line at equal steps are met at equal steps") {
  const std::vector<Point> two{{0, 0, 0}, {4, 0, 2}}, four{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  for (const Knots knots : every_knots) {
    CHECK(is_near(catmull_rom(two, knots).at(0.25), {1, 0, 0.5}));
    for (double u = 0; u <= 1; u += 0.0625) CHECK(is_near(catmull_rom(four, knots).at(u), {3 * u, 0, 0}));
  }
}

TEST_CASE(
    "Where points crowd, the uniform curve turns back between two of them, and the centripetal never does") {
  // Yuksel's case: a short leg between two long ones. Along the short leg the uniform curve runs backwards.
  const std::vector<Point> crowded{{0, 0, 0}, {10, 0, 0}, {10.1, 0.1, 0}, {10, 10, 0}};
  const auto turns_back = [&](Knots knots) {
    const Bezier leg = catmull_rom_legs(crowded, knots)[1];
    const Vector way = crowded[2] - crowded[1];
    bool back = false;
    for (double u = 0; u <= 1; u += 1 / 64.0) back = back || leg.derivative().at(u).dot(way) < 0;
    return back;
  };
  CHECK(turns_back(Knots::uniform));
  CHECK_FALSE(turns_back(Knots::centripetal));
}

TEST_CASE("No leg of a centripetal curve crosses itself in the plane, and of uniform ones some do") {
  const std::uint64_t seed = 1713;
  Chance chance(seed);
  int uniform_loops = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Point> p;
    for (int i = 0; i < 4; ++i) p.emplace_back(chance.uniform(-1, 1), chance.uniform(-1, 1), 0);
    CAPTURE(seed, round);
    CHECK_FALSE(crosses_itself(catmull_rom_legs(p, Knots::centripetal)[1]));
    uniform_loops += crosses_itself(catmull_rom_legs(p, Knots::uniform)[1]);
  }
  CHECK(uniform_loops > 0);
}

TEST_CASE("Where two points in a row are equal, the curve halts") {
  const std::vector<Point> twice{{0, 0, 0}, {1, 1, 0}, {1, 1, 0}, {2, 0, 0}};
  for (const Knots knots : {Knots::centripetal, Knots::chordal}) {
    const auto legs = catmull_rom_legs(twice, knots);
    for (const double u : {0.0, 0.3, 1.0}) CHECK(legs[1].at(u) == Point(1, 1, 0));
    CHECK(legs[0].derivative().at(1).norm() == 0);
    CHECK(catmull_rom(twice, knots).breaks().size() == 4);
  }
  const std::vector<Point> nowhere{{1, 2, 3}, {1, 2, 3}};
  CHECK(catmull_rom(nowhere).at(0.5) == Point(1, 2, 3));
}

TEST_CASE("Joined curves are the curves, one after the other, also of different degrees") {
  const std::vector<Bezier> row{line({0, 0, 0}, {1, 0, 0}), Bezier({{1, 0, 0}, {2, 3, 0}, {3, 0, 1}}),
                                Bezier({{3, 0, 1}, {4, 4, 4}, {5, -4, 2}, {6, 0, 0}, {7, 7, 7}})};
  const std::vector<double> spans{1, 2, 1};
  const BSpline chain = joined(row, spans);
  CHECK(chain.degree() == 4);
  CHECK(chain.breaks() == std::vector<double>{0, 0.25, 0.75, 1});
  for (double u = 0; u <= 1; u += 0.0625) {
    CHECK(is_near(chain.at(u / 4), row[0].at(u)));
    CHECK(is_near(chain.at(0.25 + u / 2), row[1].at(u)));
    CHECK(is_near(chain.at(0.75 + u / 4), row[2].at(u)));
  }
}

TEST_CASE("A part of a Bezier curve is the curve there, also backwards and beyond its ends") {
  const Bezier curve({{0, 0, 0}, {1, 4, 0}, {3, -2, 1}, {4, 0, 0}});
  for (const auto& [from, to] : {std::pair(0.0, 1.0), {0.25, 0.75}, {1.0, 0.0}, {-0.25, 1.5}, {0.5, 0.5}}) {
    const Bezier part = curve.part(from, to);
    for (double u = 0; u <= 1; u += 0.125) CHECK(is_near(part.at(u), curve.at(from + u * (to - from))));
  }
  CHECK(curve.part(0, 1).control_points() == curve.control_points());
  CHECK(is_near(curve.elevated().at(0.3), curve.at(0.3)));
}

TEST_CASE("Too few points, a point that is no number, and curves that do not meet are refused") {
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point> one{{0, 0, 0}}, bad{{0, 0, 0}, {1, no_number, 0}};
  CHECK_THROWS_WITH(catmull_rom(one), "curve through points: must have two points or more");
  CHECK_THROWS_AS(catmull_rom(bad), std::invalid_argument);
  CHECK_THROWS_AS(hermite({0, 0, 0}, {no_number, 0, 0}, {1, 0, 0}, {0, 0, 0}), std::invalid_argument);
  const std::vector<Bezier> apart{line({0, 0, 0}, {1, 0, 0}), line({1, 0, 1e-9}, {2, 0, 0})};
  CHECK_THROWS_WITH(joined(apart), "joined curve 1: must begin where the one before ends");
  CHECK_THROWS_AS(joined({}), std::invalid_argument);
  const std::vector<Bezier> whole{line({0, 0, 0}, {1, 0, 0})};
  for (const double span : {0.0, -1.0, no_number}) {
    const std::vector<double> spans{span};
    CHECK_THROWS_AS(joined(whole, spans), std::invalid_argument);
  }
}
