#include "first_contact/motion/easing_family.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"

using namespace first_contact;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

// Penner's formulas as published, for a way of 1 in a time of 1.
double published_in_back(double t, double s) { return t * t * ((s + 1) * t - s); }
double published_in_out_back(double t, double s) {
  const double wide = s * 1.525, half = 2 * t;
  if (half < 1) return 0.5 * (half * half * ((wide + 1) * half - wide));
  return 0.5 * ((half - 2) * (half - 2) * ((wide + 1) * (half - 2) + wide) + 2);
}
double published_in_elastic(double t, double a, double p) {
  const double s = p / (2 * pi) * std::asin(1 / a);
  return -(a * std::pow(2, 10 * (t - 1)) * std::sin((t - 1 - s) * (2 * pi) / p));
}
double published_in_exponential(double t) { return std::pow(2, 10 * (t - 1)); }

template <class Check>
void at_64_times(Check check) {
  for (int i = 1; i < 64; ++i) check(i / 64.0);
}

}  // namespace

TEST_CASE("With its usual parameter a family is the plain easing, bit for bit") {
  at_64_times([](double t) {
    CHECK(ease::back()(t) == ease::in_back(t));
    CHECK(ease::elastic()(t) == ease::in_elastic(t));
    CHECK(ease::exponential(10)(t) == ease::in_exponential(t));
    CHECK(ease::out(ease::back())(t) == ease::out_back(t));
    CHECK(ease::in_out(ease::in_cubic)(t) == ease::in_out_cubic(t));
    CHECK(ease::power(2)(t) == Approx(ease::in_quadratic(t)).epsilon(1e-15));
    CHECK(ease::power(5)(t) == Approx(ease::in_quintic(t)).epsilon(1e-15));
  });
}

TEST_CASE("Back is Penner's, for any overshoot") {
  for (const double s : {0.0, 0.5, 1.70158, 10.0})
    at_64_times([s](double t) {
      CHECK(ease::back(s)(t) == Approx(published_in_back(t, s)).margin(rounding * (1 + s)));
      CHECK(ease::in_out(ease::back(1.525 * s))(t) ==
            Approx(published_in_out_back(t, s)).margin(2 * rounding * (1 + s)));
    });
}

TEST_CASE("Back goes 4 s^3 / (27 (s + 1)^2) in the wrong direction, where it turns") {
  for (const double s : {0.5, 1.70158, 10.0}) {
    const Easing back = ease::back(s);
    REQUIRE(back.turns().size() == 1);
    CHECK(back(back.turns()[0]) == Approx(-4 * s * s * s / (27 * (s + 1) * (s + 1))).epsilon(1e-14));
  }
  CHECK(ease::back(0).turns().empty());
}

TEST_CASE("Back turns at 2 s / (3 (s + 1)), at two thirds for the largest overshoot") {
  CHECK(ease::back(1).turns() == std::vector{1.0 / 3});
  CHECK(ease::back(std::numeric_limits<double>::max()).turns() == std::vector{2.0 / 3});
}

TEST_CASE("Back without overshoot never turns") {
  CHECK(ease::back(0).turns().empty());
  CHECK(ease::back(1e-6).turns().size() == 1);
}

TEST_CASE("Elastic and exponential are Penner's but for the 2^-10 that they take off at the start") {
  CHECK(published_in_exponential(0) == 0x1p-10);  // the published one jumps from 0 to this
  at_64_times([](double t) {
    const double fraction = published_in_exponential(t), ours = (1024 * fraction - 1) / 1023;
    CHECK(ease::exponential(10)(t) == Approx(ours).epsilon(1e-12));
    for (const auto& [a, p] : {std::pair(1.0, 0.3), {1.0, 0.45}, {1.5, 0.3}, {4.0, 0.2}})
      CHECK(ease::elastic(a, p)(t) ==
            Approx(published_in_elastic(t, a, p) * ours / fraction).margin(1e-13 * a));
  });
  CHECK(ease::in_elastic(1e-9) == Approx(0).margin(1e-9));
}

TEST_CASE("As its exponent gets small an exponential easing is linear, down to the smallest number") {
  for (const double b : {5e-324, -5e-324, 1e-310, 1e-30, 0x1p-60, 0x1p-59, -1e-17}) {
    CAPTURE(b);
    at_64_times([b](double t) { CHECK(ease::exponential(b)(t) == Approx(t).epsilon(1e-15)); });
  }
}

TEST_CASE("An elastic easing turns twice in a period, its last swing reaching nearly its amplitude") {
  for (const double p : {0.3, 0.15, 1.0 / 64}) {
    const auto turns = ease::elastic(1, p).turns();
    CHECK(std::abs(static_cast<double>(turns.size()) - 2 / p) <= 2);
    for (std::size_t i = 2; i < turns.size(); ++i)
      CHECK(turns[i] - turns[i - 1] == Approx(p / 2).epsilon(0.05));
  }
  const Easing wide = ease::elastic(3, 0.3);
  double highest = 0;
  for (int i = 0; i <= 10000; ++i) highest = std::max(highest, wide(i / 10000.0));
  CHECK(highest > 1.5);
  CHECK(highest <= 3);
}

TEST_CASE("A mirrored easing turns at the mirrored times") {
  for (const Easing& in : {ease::back(3), ease::elastic(2, 0.25), Easing(ease::in_bounce)}) {
    const Easing out = ease::out(in), both = ease::in_out(in);
    REQUIRE(out.turns().size() == in.turns().size());
    REQUIRE(both.turns().size() == 2 * in.turns().size());
    CHECK(std::is_sorted(out.turns().begin(), out.turns().end()));
    CHECK(std::is_sorted(both.turns().begin(), both.turns().end()));
    CHECK(out.turns().back() == 1 - in.turns().front());
    CHECK(both.turns().front() == in.turns().front() / 2);
  }
}

TEST_CASE("A spring obeys its equation: x'' = w^2 (x_end - x) - 2 z w x'") {
  for (const double z : {0.1, 0.5, 0.999999, 1.0, 1.5, 4.0})
    for (const double cycles : {0.5, 2.0, 8.0}) {
      const Easing spring = ease::spring(cycles, z);
      const double w = 2 * pi * cycles, h = 1e-4 / cycles;
      CAPTURE(z, cycles);
      // Its way is divided by x(1); the goal is then 1 / x(1), which this finds from the equation at two times.
      const auto goal = [&](double t) {
        const double x = spring(t), v = (spring(t + h) - spring(t - h)) / (2 * h);
        return x + ((spring(t + h) - 2 * x + spring(t - h)) / (h * h) + 2 * z * w * v) / (w * w);
      };
      const double expected = goal(0.5);
      for (const double t : {0.1, 0.3, 0.77}) CHECK(goal(t) == Approx(expected).epsilon(1e-4));
      CHECK(spring(1e-6) < 1e-6);  // at rest at first
    }
}

TEST_CASE(
    "A spring swings beyond its goal below the critical damping, by e^(-pi z / root(1 - z^2)), and never "
    "above") {
  for (const double z : {0.1, 0.3, 0.7}) {
    const Easing spring = ease::spring(8, z);
    REQUIRE(!spring.turns().empty());
    CHECK(spring.turns()[0] == Approx(1 / (16 * std::sqrt(1 - z * z))).epsilon(1e-6));
    if (z == 0.7)
      CHECK(spring(spring.turns()[0]) == Approx(1 + std::exp(-pi * z / std::sqrt(1 - z * z))).epsilon(1e-9));
  }
  for (const double z : {1.0, 1.1, 5.0}) CHECK(ease::spring(8, z).turns().empty());
}

TEST_CASE("Near the critical damping the three formulas of a spring are one") {
  for (const double t : {0.05, 0.4, 0.9}) {
    const double critical = ease::spring(2, 1)(t);
    CHECK(ease::spring(2, 1 - 1e-9)(t) == Approx(critical).epsilon(1e-6));
    CHECK(ease::spring(2, 1 + 1e-9)(t) == Approx(critical).epsilon(1e-6));
  }
}

TEST_CASE("Parameters out of range are refused, and named") {
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(ease::power(-1), "easing's exponent -1: must be positive and finite");
  CHECK_THROWS_WITH(ease::elastic(0.5), "easing's amplitude 0.5: must be finite and at least 1");
  CHECK_THROWS_WITH(ease::elastic(1, 0), "easing's period 0: must be finite and at least 1/64");
  CHECK_THROWS_WITH(ease::spring(100, 1), "spring's cycles 100: must be from 0.001 to 64");
  CHECK_THROWS_WITH(ease::spring(1, 1e300), "spring's damping 1e+300: must be from 0.01 to 100");
  CHECK_THROWS_WITH(ease::spring(1, 1e-6), "spring's damping 1e-06: must be from 0.01 to 100");
  for (const double bad : {0.0, no_number}) {
    CHECK_THROWS_AS(ease::power(bad), std::invalid_argument);
    CHECK_THROWS_AS(ease::exponential(bad), std::invalid_argument);
    CHECK_THROWS_AS(ease::spring(bad, 1), std::invalid_argument);
    CHECK_THROWS_AS(ease::spring(1, bad), std::invalid_argument);
  }
  CHECK_THROWS_AS(ease::back(-1), std::invalid_argument);
  CHECK_THROWS_AS(ease::back(no_number), std::invalid_argument);
}
