#include "first_contact/motion/bounce.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"

using namespace first_contact;

namespace {

using Exact = boost::multiprecision::cpp_dec_float_50;
constexpr double eps = std::numeric_limits<double>::epsilon();

// The bounce in 50 digits, impact after impact, by the plain formulas: no closed form, no care for
// cancellation.
struct ExactBounce {
  Exact h, v, g, e;

  Exact first_speed() const { return sqrt(v * v + 2 * g * h); }
  Exact first_time() const { return g == 0 ? Exact(h / v) : Exact((first_speed() - v) / g); }
};

struct Scene {
  double h, v, g, e;
};

struct Scenes {
  explicit Scenes(unsigned seed) : random(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  double decade(double low, double high) { return std::pow(10, number(low, high)); }

  Scene next() {
    const double e = random() % 4 == 0 ? 1 - decade(-9, -1) : number(0.01, 1);
    const double v = (random() % 2 ? 1 : -1) * decade(-4, 4);
    return {decade(-4, 4), v, decade(-3, 3), e};
  }

  std::mt19937_64 random;
};

double error(double value, const Exact& exact) {
  return std::abs(static_cast<double>((Exact(value) - exact) / exact)) / eps;
}

}  // namespace

TEST_CASE("Impacts and apexes agree with 50 digits, impact after impact") {
  Scenes scenes(71);
  double worst_first = 0, worst = 0, worst_speed = 0;
  for (int i = 0; i < 3000; ++i) {
    const Scene s = scenes.next();
    CAPTURE(i, s.h, s.v, s.g, s.e);
    const Bounce bounce(s.h, s.v, s.g, s.e);
    const ExactBounce truth{s.h, s.v, s.g, s.e};
    Exact time = truth.first_time(), speed = truth.first_speed();
    worst_first = std::max(worst_first, error(bounce.impact(1)->time, time));
    for (std::size_t n = 1; n <= 40; ++n) {
      worst = std::max(worst, error(bounce.impact(n)->time, time));
      worst_speed = std::max(worst_speed, error(bounce.impact(n)->speed, speed));
      speed *= truth.e;
      const Exact top = time + speed / truth.g, height = speed * speed / (2 * truth.g);
      worst = std::max(worst, error(bounce.apex(n)->time, top));
      worst_speed = std::max(worst_speed, error(bounce.apex(n)->height, height) / 2);
      time += 2 * speed / truth.g;
    }
  }
  CAPTURE(worst_first, worst, worst_speed);
  CHECK(worst_first < 4);
  CHECK(worst < 8);
  CHECK(worst_speed < 6);
}

TEST_CASE("The time of rest agrees with 50 digits, however near to 1 the restitution is") {
  Scenes scenes(72);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Scene s = scenes.next();
    const ExactBounce truth{s.h, s.v, s.g, s.e};
    const Exact rest = truth.first_time() + 2 * truth.first_speed() * truth.e / (truth.g * (1 - truth.e));
    worst = std::max(worst, error(*Bounce(s.h, s.v, s.g, s.e).rest_time(), rest));
  }
  CAPTURE(worst);
  CHECK(worst < 6);
}

TEST_CASE("The millionth impact agrees with 50 digits") {
  for (const double e : {1.0, 1 - 1e-9, 0.999999, 0.99999}) {
    const std::size_t n = 1000000;
    const ExactBounce truth{2.5, -3, 9.81, e};
    const Exact power = pow(truth.e, static_cast<long>(n - 1));
    const Exact sum = e == 1 ? Exact(n - 1) : Exact((1 - power) / (1 - truth.e));
    const Exact time = truth.first_time() + 2 * truth.e * truth.first_speed() / truth.g * sum;
    CAPTURE(e);
    CHECK(error(Bounce(2.5, -3, 9.81, e).impact(n)->time, time) < 8);
  }
}

TEST_CASE("The height at any time agrees with 50 digits, to within what the rounding of a time is worth") {
  Scenes scenes(73);
  for (int i = 0; i < 3000; ++i) {
    const Scene s = scenes.next();
    const Bounce bounce(s.h, s.v, s.g, s.e);
    const ExactBounce truth{s.h, s.v, s.g, s.e};
    const double now = scenes.number(0, 5) * bounce.impact(1)->time;
    Exact begin = 0, next = truth.first_time(), up = -truth.v, start = truth.h, down = truth.first_speed();
    for (int n = 0; n < 400 && next <= Exact(now); ++n) {
      begin = next;
      up = down = truth.e * down;
      start = 0;
      next += 2 * up / truth.g;
    }
    if (next <= Exact(now)) continue;  // at rest, or too many impacts for this test
    const Exact since = Exact(now) - begin, height = start + up * since - truth.g / 2 * since * since;
    // An error of the time is worth speed times error; the height itself is a sum of terms no larger than
    // these.
    const double speed = static_cast<double>(truth.first_speed());
    const double scale = s.h + speed * now;
    CAPTURE(i, s.h, s.v, s.g, s.e, now);
    CHECK(std::abs(static_cast<double>(Exact(bounce.height(now)) - height)) <= 16 * eps * scale);
  }
}

TEST_CASE("The flight touches the floor at its impacts and nowhere else: dense sampling") {
  Scenes scenes(74);
  for (int i = 0; i < 200; ++i) {
    const Scene s = scenes.next();
    const Bounce bounce(s.h, s.v, s.g, s.e);
    for (std::size_t n = 1; n < 6; ++n) {
      const double begin = bounce.impact(n)->time, end = bounce.impact(n + 1)->time;
      if (!(end - begin > 1e-9 * end)) break;
      for (int k = 1; k < 50; ++k) CHECK(bounce.height(begin + (end - begin) * k / 50) > 0);
    }
  }
}
