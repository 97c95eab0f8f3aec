#include "first_contact/motion/arc_length.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/motion/path.hpp"

using namespace first_contact;

namespace {

using Wide = long double;

std::vector<Point> random_points(Chance& chance, std::size_t count) {
  std::vector<Point> points;
  while (points.size() < count) points.push_back(chance.vector(5));
  return points;
}

std::vector<Point> on_the_x_axis(std::vector<Point> points) {
  for (Point& p : points) p.y() = p.z() = 0;
  return points;
}

// How far a polynomial on [0, 1], given by its Bezier coefficients, goes to and fro. Where they rise or fall
// throughout it goes one way.
Wide to_and_fro(std::vector<Wide> p, int halvings = 70) {
  if (std::is_sorted(p.begin(), p.end()) || std::is_sorted(p.rbegin(), p.rend()) || halvings == 0)
    return std::abs(p.back() - p.front());
  std::vector<Wide> left;
  for (std::size_t n = p.size(); n > 0; --n) {
    left.push_back(p.front());
    for (std::size_t i = 0; i + 1 < n; ++i) p[i] = (p[i] + p[i + 1]) / 2;
  }
  return to_and_fro(std::move(left), halvings - 1) + to_and_fro(std::move(p), halvings - 1);
}

Wide to_and_fro(const std::vector<Point>& points) {
  std::vector<Wide> x;
  for (const Point& p : points) x.push_back(p.x());
  return to_and_fro(std::move(x));
}

using WidePoint = std::array<Wide, 3>;

Wide speed(const std::vector<Point>& points, Wide u) {
  std::vector<WidePoint> d;
  const auto degree = static_cast<Wide>(points.size() - 1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    d.push_back({degree * (Wide(points[i + 1].x()) - points[i].x()),
                 degree * (Wide(points[i + 1].y()) - points[i].y()),
                 degree * (Wide(points[i + 1].z()) - points[i].z())});
  for (std::size_t left = d.size() - 1; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i)
      for (std::size_t k = 0; k < 3; ++k) d[i][k] = (1 - u) * d[i][k] + u * d[i + 1][k];
  return std::hypot(d[0][0], d[0][1], d[0][2]);
}

// By thirty points of Gauss's rule on each of very many pieces.
Wide by_gauss(const std::vector<Point>& points) {
  constexpr int pieces = 2000;
  Wide sum = 0;
  for (int i = 0; i < pieces; ++i)
    sum += boost::math::quadrature::gauss<Wide, 30>::integrate([&](Wide u) { return speed(points, u); },
                                                               Wide(i) / pieces, Wide(i + 1) / pieces);
  return sum;
}

}  // namespace

TEST_CASE("A straight curve is as long as the way it goes to and fro, for any degree up to 20") {
  const std::uint64_t seed = 1101;
  Chance chance(seed);
  for (std::size_t degree = 1; degree <= 20; ++degree)
    for (int i = 0; i < 200; ++i) {
      const auto points = on_the_x_axis(random_points(chance, degree + 1));
      CAPTURE(seed, degree, i);
      const Wide truth = to_and_fro(points);
      REQUIRE(std::abs(ArcLength(Bezier(points)).total() - truth) <= ArcLength::relative_error * truth);
    }
}

TEST_CASE("A straight curve of small whole numbers, with its ends twice or thrice, is measured too") {
  const std::uint64_t seed = 1102;
  Chance chance(seed);
  for (int i = 0; i < 3000; ++i) {
    std::vector<Point> points;
    for (std::size_t k = 2 + chance.pick(6); k > 0; --k)
      points.emplace_back(static_cast<double>(chance.pick(5)) - 2, 0, 0);
    points.insert(points.begin(), chance.pick(3), points.front());
    points.insert(points.end(), chance.pick(3), points.back());
    CAPTURE(seed, i);
    const Wide truth = to_and_fro(points);
    REQUIRE(std::abs(ArcLength(Bezier(points)).total() - truth) <= ArcLength::relative_error * truth);
  }
}

TEST_CASE("Every part of a straight curve that turns back is as long as its own way to and fro") {
  const std::uint64_t seed = 1103;
  Chance chance(seed);
  for (int i = 0; i < 300; ++i) {
    const auto points = on_the_x_axis(random_points(chance, 3 + chance.pick(5)));
    const ArcLength length((Bezier(points)));
    const double u = chance.uniform(0, 1);
    std::vector<Wide> whole, part;
    for (const Point& p : points) whole.push_back(p.x());
    for (std::size_t n = whole.size(); n > 0; --n) {
      part.push_back(whole.front());
      for (std::size_t k = 0; k + 1 < n; ++k) whole[k] = (1 - Wide(u)) * whole[k] + Wide(u) * whole[k + 1];
    }
    CAPTURE(seed, i, u);
    REQUIRE(std::abs(length.to(u) - to_and_fro(part)) <= ArcLength::relative_error * length.total());
  }
}

TEST_CASE("A curve of degree 144 is measured in a moment, straight or not") {
  const std::uint64_t seed = 1104;
  Chance chance(seed);
  const auto points = random_points(chance, 145);
  const auto straight = on_the_x_axis(points);
  const Wide truth = to_and_fro(straight);
  CHECK(std::abs(ArcLength(Bezier(straight)).total() - truth) <= ArcLength::relative_error * truth);
  CHECK(ArcLength(Bezier(points)).total() > ArcLength(Bezier(straight)).total());
}

TEST_CASE("Lengths of Bezier curves agree with thirty points of Gauss on two thousand pieces") {
  const std::uint64_t seed = 1105;
  Chance chance(seed);
  for (int i = 0; i < 60; ++i) {
    auto points = random_points(chance, 3 + chance.pick(5));
    if (i % 3 == 1) points.insert(points.begin(), points.front());
    if (i % 3 == 2)
      for (Point& p : points) p.z() = 0;
    CAPTURE(seed, i);
    const Wide truth = by_gauss(points);
    REQUIRE(std::abs(ArcLength(Bezier(points)).total() - truth) <= ArcLength::relative_error * truth);
  }
}

TEST_CASE("Cubics with a cusp, and near one, are as long as long double says") {
  // (1, 1), (t, t) and their mirror images: at t = -1/3 there is a cusp, near it a narrow turn.
  for (const double off : {0.0, 1e-12, 1e-9, 1e-6, 1e-4, -1e-4, -1e-6, -1e-9}) {
    const double t = -1.0 / 3 + off;
    const std::vector<Point> points{{1, -1, 0}, {t, 1, 0}, {t, -1, 0}, {1, 1, 0}};
    Wide truth = 0;  // the turn is at 1/2: pieces that shrink towards it
    for (int k = 1; k < 60; ++k) {
      const Wide a = std::ldexp(Wide(1), -k), b = k == 59 ? 0 : a / 2;
      const auto at = [&](Wide s) { return speed(points, (1 + s) / 2) + speed(points, (1 - s) / 2); };
      truth += boost::math::quadrature::gauss<Wide, 30>::integrate(at, b, a) / 2;
    }
    truth += boost::math::quadrature::gauss<Wide, 30>::integrate(
                 [&](Wide s) { return speed(points, (1 + s) / 2) + speed(points, (1 - s) / 2); }, Wide(0.5),
                 Wide(1)) /
             2;
    CAPTURE(off);
    CHECK(std::abs(ArcLength(Bezier(points)).total() - truth) <= ArcLength::relative_error * truth);
  }
}

TEST_CASE("A B-spline is as long as its pieces, a straight one as far as it goes to and fro") {
  const std::uint64_t seed = 1106;
  Chance chance(seed);
  for (int i = 0; i < 300; ++i) {
    const std::size_t degree = 1 + chance.pick(5);
    const BSpline spline(random_points(chance, degree + 1 + chance.pick(6)), degree);
    double sum = 0;
    for (const Bezier& piece : spline.pieces()) sum += ArcLength(piece).total();
    CAPTURE(seed, i, degree);
    CHECK(std::abs(ArcLength(spline).total() - sum) <= 2 * ArcLength::relative_error * sum);
    const BSpline straight(on_the_x_axis(spline.control_points()), degree);
    Wide truth = 0;
    for (const Bezier& piece : straight.pieces()) truth += to_and_fro(piece.control_points());
    CHECK(std::abs(ArcLength(straight).total() - truth) <= ArcLength::relative_error * truth);
  }
}

TEST_CASE(
    "A curve through points is as long as its legs, through points of a line as far as it goes to and fro") {
  const std::uint64_t seed = 1108;
  Chance chance(seed);
  for (int i = 0; i < 300; ++i) {
    const auto knots = std::array{Knots::uniform, Knots::centripetal, Knots::chordal}[chance.pick(3)];
    auto points = random_points(chance, 2 + chance.pick(6));
    if (i % 4 == 0) points.insert(points.begin() + 1, points.front());
    const BSpline curve = catmull_rom(points, knots), straight = catmull_rom(on_the_x_axis(points), knots);
    Wide legs = 0, truth = 0;
    for (const Bezier& leg : catmull_rom_legs(points, knots)) legs += ArcLength(leg).total();
    for (const Bezier& piece : straight.pieces()) truth += to_and_fro(piece.control_points());
    CAPTURE(seed, i);
    CHECK(std::abs(ArcLength(curve).total() - legs) <= 2 * ArcLength::relative_error * legs);
    CHECK(std::abs(ArcLength(straight).total() - truth) <= ArcLength::relative_error * truth);
  }
}

TEST_CASE("A path of several straight legs is as long as they are together, there and back") {
  const std::uint64_t seed = 1109;
  Chance chance(seed);
  for (int i = 0; i < 200; ++i) {
    const auto corners = on_the_x_axis(random_points(chance, 3 + chance.pick(4)));
    const std::vector<Point> joints(corners.begin() + 1, corners.end() - 1);
    const Leg leg(Path::of_legs(std::vector<Path>(corners.size() - 1), joints), corners.front(),
                  corners.back());
    Wide truth = 0;
    for (std::size_t k = 1; k < corners.size(); ++k)
      truth += std::abs(Wide(corners[k].x()) - corners[k - 1].x());
    CAPTURE(seed, i);
    CHECK(std::abs(leg.by_length()->total() - truth) <= ArcLength::relative_error * truth);
  }
}

TEST_CASE("The pieces of a B-spline are the B-spline") {
  const std::uint64_t seed = 1107;
  Chance chance(seed);
  for (int i = 0; i < 100; ++i) {
    const std::size_t degree = 1 + chance.pick(4);
    const BSpline spline(random_points(chance, degree + 1 + chance.pick(6)), degree);
    const auto joints = spline.breaks();
    const auto pieces = spline.pieces();
    REQUIRE(pieces.size() + 1 == joints.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const double s = chance.uniform(0.01, 0.99);
      CAPTURE(seed, i, degree, k, s);
      CHECK((pieces[k].at(s) - spline.at(std::lerp(joints[k], joints[k + 1], s))).norm() < 1e-13 * 5);
    }
  }
}
