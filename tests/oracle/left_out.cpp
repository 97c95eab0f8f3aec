// What goes through the C library's sine, power or logarithm is not the same on every machine: here is how far it may
// be from the truth, as the README says.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/geometry/bounding.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/motion/easing_family.hpp"
#include "first_contact/motion/rigid_tween.hpp"
#include "first_contact/motion/squash.hpp"

using namespace first_contact;

namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;
constexpr double eps = std::numeric_limits<double>::epsilon();

const Exact pi = acos(Exact(-1));

double error(double value, const Exact& truth) { return std::abs(static_cast<double>(value - truth)) / eps; }

Exact exponential(const Exact& t) { return (pow(Exact(2), 10 * t) - 1) / 1023; }

// The way of a damped oscillation towards 1, below and above the critical damping.
Exact spring(const Exact& t, const Exact& cycles, const Exact& z) {
  const Exact w = 2 * pi * cycles, v = w * sqrt(abs(1 - z * z));
  const Exact c = z < 1 ? Exact(cos(v * t)) : Exact(cosh(v * t)),
              s = z < 1 ? Exact(sin(v * t)) : Exact(sinh(v * t));
  return 1 - exp(-z * w * t) * (c + z * w / v * s);
}

// A vector turned about a unit axis (Rodrigues).
Eigen::Matrix<Exact, 3, 1> turned(const Vector& axis, const Exact& angle, const Vector& v) {
  const Exact length =
      sqrt(Exact(axis.x()) * axis.x() + Exact(axis.y()) * axis.y() + Exact(axis.z()) * axis.z());
  const Exact x = axis.x() / length, y = axis.y() / length, z = axis.z() / length;
  const Exact along = x * v.x() + y * v.y() + z * v.z(), c = cos(angle), s = sin(angle);
  return {v.x() * c + (y * v.z() - z * v.y()) * s + x * along * (1 - c),
          v.y() * c + (z * v.x() - x * v.z()) * s + y * along * (1 - c),
          v.z() * c + (x * v.y() - y * v.x()) * s + z * along * (1 - c)};
}

double error(const Vector& value, const Eigen::Matrix<Exact, 3, 1>& truth) {
  double worst = 0;
  for (int i = 0; i < 3; ++i) worst = std::max(worst, error(value[i], truth[i]));
  return worst;
}

}  // namespace

TEST_CASE("Easings by a sine or a power are right to 4 eps, by a spring to 24") {
  const std::uint64_t seed = 1401;
  Chance chance(seed);
  for (int i = 0; i < 3000; ++i) {
    const double t = chance.uniform(0, 1);
    CAPTURE(seed, i, t);
    REQUIRE(error(ease::in_sine(t), 1 - cos(pi / 2 * t)) < 4);
    REQUIRE(error(ease::in_exponential(t), exponential(t)) < 4);
    REQUIRE(error(ease::in_elastic(t), exponential(t) * cos(20 * pi / 3 * (1 - Exact(t)))) < 24);
  }
}

TEST_CASE("A power is right to 4 eps") {
  const std::uint64_t seed = 1406;
  Chance chance(seed);
  for (int i = 0; i < 1000; ++i) {
    const double t = chance.uniform(0, 1), n = chance.log_uniform(0.05, 4);
    CAPTURE(seed, i, t, n);
    REQUIRE(error(ease::power(n)(t), pow(Exact(t), Exact(n))) < 4);
  }
}

// Also where it swings whole cycles almost undamped, so that it is nearly back where it began, where it is critical but
// for a rounding or so, and where it only begins to move or creeps.
TEST_CASE("A spring is right to 64 eps, and 16 more for each of its cycles, wherever it is defined") {
  const std::uint64_t seed = 1408;
  Chance chance(seed);
  for (int i = 0; i < 4000; ++i) {
    const double t = chance.uniform(0, 1), any = chance.log_uniform(0.001, 64);
    const double cycles = chance.pick(4) == 0 ? std::ceil(any) : any;
    const double near_1 = 1 + chance.log_uniform(0x1p-52, 0.01) * (chance.pick(2) == 0 ? 1 : -1);
    const double z =
        chance.pick(4) == 0 ? near_1 : chance.log_uniform(0.01, chance.pick(2) == 0 ? 0.05 : 100);
    const Exact truth = spring(t, cycles, z) / spring(1, cycles, z);
    CAPTURE(seed, i, t, cycles, z);
    REQUIRE(error(ease::spring(cycles, z)(t), truth) <
            (64 + 16 * cycles) * std::max(1.0, static_cast<double>(truth)));
  }
}

TEST_CASE("A stretch that is eased is right to 4 eps of itself") {
  const std::uint64_t seed = 1407;
  Chance chance(seed);
  for (int i = 0; i < 1000; ++i) {
    const double a = chance.log_uniform(0.01, 100), b = chance.log_uniform(0.01, 100),
                 t = chance.uniform(0, 1);
    const Exact truth = a * pow(Exact(b) / a, Exact(t));
    CAPTURE(seed, i, a, b, t);
    REQUIRE(error(eased_stretch(a, b, ease::linear, t), truth) < 4 * static_cast<double>(truth));
  }
}

TEST_CASE("A damped step is right to 4 eps of the numbers between which it goes") {
  const std::uint64_t seed = 1402;
  Chance chance(seed);
  for (int i = 0; i < 3000; ++i) {
    const double from = chance.uniform(-1, 1), goal = chance.uniform(-1, 1),
                 rate = chance.log_uniform(1e-6, 1e3);
    const double dt = chance.log_uniform(1e-6, 1);
    CAPTURE(seed, i);
    REQUIRE(error(damp(from, goal, rate, dt), goal + (from - Exact(goal)) * exp(-Exact(rate) * dt)) < 4);
  }
}

TEST_CASE("A turn by an angle is right to 16 eps, and so is one that is tweened") {
  const std::uint64_t seed = 1403;
  Chance chance(seed);
  for (int i = 0; i < 1000; ++i) {
    const Vector axis = chance.vector(1), v = chance.vector(1);
    const double angle = chance.uniform(-3, 3), part = chance.uniform(0, 1);
    CAPTURE(seed, i, angle, part);
    REQUIRE(error(Rigid::turned(axis, angle).direction(v), turned(axis, angle, v)) < 16);
    const Quaternion whole(Eigen::AngleAxisd(angle, normalized(axis)));
    const RigidTween tween({{0, {0, 0, 0}, Quaternion::Identity()}, {1, {0, 0, 0}, whole}});
    REQUIRE(error(tween.at(part).direction(v), turned(axis, Exact(angle) * part, v)) < 16);
  }
}

TEST_CASE("A perspective's scale, the cotangent of half its angle, is right to 4 eps of itself") {
  const std::uint64_t seed = 1404;
  Chance chance(seed);
  for (int i = 0; i < 1000; ++i) {
    const double angle = chance.uniform(0.01, 3.1);
    const Exact truth = 1 / tan(Exact(angle) / 2);
    CAPTURE(seed, i, angle);
    REQUIRE(error(Transform::perspective(angle, 1, 1, 2).matrix()(1, 1), truth) <
            4 * static_cast<double>(truth));
  }
}

TEST_CASE("A principal box is a box around its points, to 16 eps of the largest coordinate") {
  const std::uint64_t seed = 1405;
  Chance chance(seed);
  for (int i = 0; i < 300; ++i) {
    std::vector<Point> points;
    for (int k = 0; k < 20; ++k) points.push_back(chance.vector(1).cwiseProduct(Vector(4, 1, 0.25)));
    const Box box = principal_box(points);
    CAPTURE(seed, i);
    for (const Vector& axis : {box.r, box.s, box.t})
      for (const Point& p : points)
        REQUIRE(std::abs(dot(normalized(axis), p - box.center)) <= 0.5 * norm(axis) + 16 * eps * 4);
    REQUIRE(std::abs(dot(normalized(box.r), normalized(box.s))) <= 16 * eps);
    REQUIRE(std::abs(dot(normalized(box.s), normalized(box.t))) <= 16 * eps);
    REQUIRE(std::abs(dot(normalized(box.t), normalized(box.r))) <= 16 * eps);
  }
}
