#include "first_contact/motion/curve.hpp"

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"
#include "first_contact/motion/arc_length.hpp"

using namespace first_contact;

namespace {

using Exact = boost::multiprecision::cpp_dec_float_50;
constexpr double eps = std::numeric_limits<double>::epsilon();

struct Random {
  explicit Random(unsigned seed) : engine(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  std::size_t whole(std::size_t low, std::size_t high) {
    return std::uniform_int_distribution<std::size_t>(low, high)(engine);
  }
  std::vector<Point> points(std::size_t count) {
    std::vector<Point> list;
    while (list.size() < count) list.emplace_back(number(-5, 5), number(-5, 5), number(-5, 5));
    return list;
  }
  std::mt19937_64 engine;
};

// B-splines by the definition of Cox and de Boor, as a sum of basis functions: nothing of the library's
// corner cutting.
Exact basis(const std::vector<double>& k, std::size_t i, std::size_t degree, const Exact& x) {
  if (degree == 0) return x >= k[i] && x < k[i + 1] ? 1 : 0;
  Exact sum = 0;
  if (k[i + degree] > k[i]) sum += (x - k[i]) / (Exact(k[i + degree]) - k[i]) * basis(k, i, degree - 1, x);
  if (k[i + degree + 1] > k[i + 1])
    sum += (k[i + degree + 1] - x) / (Exact(k[i + degree + 1]) - k[i + 1]) * basis(k, i + 1, degree - 1, x);
  return sum;
}

Point by_definition(const BSpline& spline, double u) {
  const auto& k = spline.knots();
  const std::size_t n = spline.control_points().size(), p = spline.degree();
  const Exact x = k[p] + (Exact(k[n]) - k[p]) * u;
  Point point;
  for (int axis = 0; axis < 3; ++axis) {
    Exact sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += basis(k, i, p, x) * spline.control_points()[i][axis];
    point[axis] = static_cast<double>(sum);
  }
  return point;
}

double size_of(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& p : points) size = std::max(size, p.norm());
  return size;
}

// Length by Simpson's rule with very many steps, in long double.
double by_simpson(const Curve& curve) {
  const Curve slope = derivative(curve);
  const auto joints = breaks(curve);
  long double sum = 0;
  for (std::size_t i = 1; i < joints.size(); ++i) {
    const int steps = 20000;
    const double inside = 1e-15;  // a joint belongs to the piece on its right: stay left of it
    const double a = joints[i - 1], h = (joints[i] - a) * (1 - inside) / steps;
    for (int k = 0; k < steps; ++k)
      sum += static_cast<long double>(h) / 6 *
             (at(slope, a + k * h).norm() + 4 * at(slope, a + (k + 0.5) * h).norm() +
              at(slope, a + (k + 1) * h).norm());
  }
  return static_cast<double>(sum);
}

}  // namespace

TEST_CASE("B-splines agree with the sum of their basis functions in 50 digits, for any knots") {
  Random random(75);
  for (int i = 0; i < 300; ++i) {
    const std::size_t degree = random.whole(1, 4), count = degree + random.whole(1, 6);
    std::vector<double> knots;
    for (double x = random.number(-3, 3); knots.size() < count + degree + 1; x += random.number(0.1, 2))
      knots.push_back(x);
    if (i % 2) {
      std::fill(knots.begin(), knots.begin() + static_cast<std::ptrdiff_t>(degree + 1), knots[degree]);
      std::fill(knots.end() - static_cast<std::ptrdiff_t>(degree + 1), knots.end(), knots[count]);
    }
    const BSpline spline(random.points(count), degree, knots);
    for (int k = 0; k < 10; ++k) {
      const double u = random.number(0, 1);
      CAPTURE(i, degree, count, u);
      CHECK((spline.at(u) - by_definition(spline, u)).norm() <= 400 * eps * size_of(spline.control_points()));
    }
  }
}

TEST_CASE("Derivatives agree with central differences") {
  Random random(76);
  for (int i = 0; i < 200; ++i) {
    const std::size_t degree = random.whole(2, 5), count = degree + random.whole(1, 5);
    const Curve curves[]{Bezier(random.points(count)), BSpline(random.points(count), degree)};
    for (const Curve& curve : curves) {
      const double u = random.number(0.001, 0.999), h = 1e-6;
      const auto joints = breaks(curve);
      if (std::any_of(joints.begin(), joints.end(),
                      [&](double joint) { return std::abs(u - joint) < 2 * h; }))
        continue;
      const Vector difference = (at(curve, u + h) - at(curve, u - h)) / (2 * h);
      CAPTURE(i, degree, count, u);
      CHECK((at(derivative(curve), u) - difference).norm() <=
            1e-6 * longest_control_vector(derivative(curve)));
    }
  }
}

TEST_CASE("Arc lengths agree with a very fine Simpson's rule, and lie between chord and control polygon") {
  Random random(77);
  for (int i = 0; i < 12; ++i) {
    const std::size_t degree = random.whole(2, 3), count = degree + random.whole(1, 4);
    const Curve curves[]{Bezier(random.points(degree + 2)), BSpline(random.points(count), degree)};
    for (const Curve& curve : curves) {
      const double total = ArcLength(curve).total();
      const auto& points = control_points(curve);
      double polygon = 0;
      for (std::size_t k = 1; k < points.size(); ++k) polygon += (points[k] - points[k - 1]).norm();
      CAPTURE(i, degree, count);
      CHECK(total >= (points.back() - points.front()).norm());
      CHECK(total <= polygon);
      CHECK(std::abs(total - by_simpson(curve)) <= 2e-11 * total);
    }
  }
}

TEST_CASE("The length of a parabola's arc agrees with 50 digits, from flat to needle-sharp") {
  for (const double a : {1e-6, 0.1, 1.0, 10.0, 1000.0}) {
    // y = a x^2 from -1 to 1: sqrt(1 + 4 a^2) + asinh(2 a) / (2 a).
    const Exact b = 2 * Exact(a);
    const Exact closed = sqrt(1 + b * b) + log(b + sqrt(1 + b * b)) / b;
    const double total = ArcLength(Bezier({{-1, a, 0}, {0, -a, 0}, {1, a, 0}})).total();
    CAPTURE(a);
    CHECK(std::abs(static_cast<double>((Exact(total) - closed) / closed)) <= ArcLength::relative_error);
  }
}
