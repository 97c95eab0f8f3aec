#include "first_contact/motion/easing.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

using namespace first_contact;

namespace {

// Rounding in units of the way, 1: sums and products of a few numbers near 1.
constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

template <class Check>
void for_each_easing(Check check) {
  for (const ease::Named& named : ease::all()) {
    CAPTURE(named.name);
    check(named);
  }
}

}  // namespace

TEST_CASE("Every easing is exactly 0 at 0 and exactly 1 at 1") {
  for_each_easing([](const ease::Named& named) {
    CHECK(named.easing(0) == 0);
    CHECK(named.easing(1) == 1);
  });
}

TEST_CASE("Every easing stays at its ends before 0 and after 1, and at NaN gives a number") {
  for_each_easing([](const ease::Named& named) {
    CHECK(named.easing(-0.5) == 0);
    CHECK(named.easing(1.5) == 1);
    CHECK(named.easing(std::numeric_limits<double>::infinity()) == 1);
    CHECK(std::isfinite(named.easing(std::nan(""))));
  });
}

TEST_CASE("Every easing is continuous, also next to its ends") {
  for_each_easing([](const ease::Named& named) {
    for (int i = 0; i < 10000; ++i)
      CHECK(std::abs(named.easing((i + 1) * 1e-4) - named.easing(i * 1e-4)) < 0.015);
    CHECK(named.easing(1e-12) == Approx(0).margin(1e-5));  // circular has a vertical tangent at one end
    CHECK(named.easing(1 - 1e-12) == Approx(1).margin(1e-5));
  });
}

TEST_CASE("An easing out is the mirror image of its easing in") {
  for_each_easing([](const ease::Named& named) {
    if (!named.name.starts_with("out")) return;
    for (double t = 0; t <= 1; t += 1.0 / 64)
      CHECK(named.easing(t) == Approx(1 - named.in(1 - t)).margin(rounding));
  });
}

TEST_CASE("An easing in-out is its own mirror image, and passes the middle at half time") {
  for_each_easing([](const ease::Named& named) {
    if (!named.name.starts_with("in-out")) return;
    CHECK(named.easing(0.5) == 0.5);
    for (double t = 0; t <= 1; t += 1.0 / 64)
      CHECK(named.easing(t) == Approx(1 - named.easing(1 - t)).margin(rounding));
  });
}

TEST_CASE("Easings in are monotonous, but for back, elastic and bounce") {
  for_each_easing([](const ease::Named& named) {
    for (const auto family : {"back", "elastic", "bounce"})
      if (named.name.ends_with(family)) return;
    for (int i = 0; i < 1000; ++i) CHECK(named.easing((i + 1) * 1e-3) >= named.easing(i * 1e-3));
  });
}

TEST_CASE("Easings have the values of their formulas") {
  CHECK(ease::in_quadratic(0.25) == 0.0625);
  CHECK(ease::in_cubic(0.5) == 0.125);
  CHECK(ease::in_quartic(0.5) == 0.0625);
  CHECK(ease::in_quintic(0.5) == 0.03125);
  CHECK(ease::in_sine(0.5) == Approx(1 - std::sqrt(0.5)).margin(rounding));
  CHECK(ease::in_exponential(0.5) == Approx(31.0 / 1023).margin(rounding));
  CHECK(ease::in_circular(0.6) == Approx(0.2).margin(rounding));
  CHECK(ease::out_quadratic(0.25) == 0.4375);
  CHECK(ease::in_out_cubic(0.75) == 0.9375);
}

TEST_CASE("Back goes a tenth of the way in the wrong direction") {
  double lowest = 0;
  for (int i = 0; i <= 10000; ++i) lowest = std::min(lowest, ease::in_back(i * 1e-4));
  CHECK(lowest == Approx(-0.1).margin(1e-5));
}

TEST_CASE("Bounce touches the floor at 1, 2, 2.5 and 2.75 of 2.75, and rises to 1/4 and 1/16 in between") {
  for (const double s : {1.0, 2.0, 2.5, 2.75})
    CHECK(ease::out_bounce(s / 2.75) == Approx(1).margin(rounding));
  CHECK(1 - ease::out_bounce(1.5 / 2.75) == Approx(1.0 / 4).margin(rounding));
  CHECK(1 - ease::out_bounce(2.25 / 2.75) == Approx(1.0 / 16).margin(rounding));
}

TEST_CASE("An easing knows where it turns back: at the extremes of its formula, and nowhere else") {
  const Easing back(ease::in_back), wave([](double t) { return t + 0.2 * std::sin(12 * t); });
  REQUIRE(back.turns().size() == 1);
  CHECK(back.turns()[0] == Approx(2 * 1.70158 / (3 * 2.70158)).epsilon(1e-7));
  REQUIRE(wave.turns().size() == 4);  // cos 12 t = -1 / 2.4
  CHECK(wave.turns()[0] == Approx(std::acos(-1 / 2.4) / 12).epsilon(1e-7));
  CHECK(wave.turns()[1] == Approx((2 * 3.14159265358979 - std::acos(-1 / 2.4)) / 12).epsilon(1e-7));
  const Easing bounce(ease::out_bounce);
  REQUIRE(bounce.turns().size() == 6);
  for (const auto& [i, s] : {std::pair(0, 1.0), {1, 1.5}, {2, 2.0}, {3, 2.25}, {4, 2.5}, {5, 2.625}})
    CHECK(bounce.turns()[static_cast<std::size_t>(i)] == Approx(s / 2.75).epsilon(1e-7));
}

TEST_CASE("Between two of its turns an easing only rises or only falls, to within rounding") {
  for_each_easing([](const ease::Named& named) {
    std::vector<double> ends{0};
    ends.insert(ends.end(), named.easing.turns().begin(), named.easing.turns().end());
    ends.push_back(1);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const double whole = named.easing(ends[i]) - named.easing(ends[i - 1]);
      double before = named.easing(ends[i - 1]);
      for (int k = 1; k <= 999; ++k) {
        const double now = named.easing(std::lerp(ends[i - 1], ends[i], k / 999.0));
        CHECK((now - before) * (whole > 0 ? 1 : -1) >= -rounding);
        before = now;
      }
    }
  });
}

TEST_CASE(
    "A function of one's own is an easing, with exact ends, and none, or one without values, is refused") {
  const Easing half([](double t) { return 0.25 + t / 2; });
  CHECK(half(0) == 0);
  CHECK(half(0.5) == 0.5);
  CHECK(half(1) == 1);
  double (*missing)(double) = nullptr;
  CHECK_THROWS_WITH(Easing(missing), "easing: must be a function");
  CHECK_THROWS_AS(Easing([](double t) { return 1 / (t - 0.5); }), std::invalid_argument);
}

TEST_CASE("Damping does not depend on the frame rate: two half steps do what one step does") {
  const double once = damp(3.0, 7.0, 2.5, 0.1);
  CHECK(damp(damp(3.0, 7.0, 2.5, 0.05), 7.0, 2.5, 0.05) == Approx(once).epsilon(1e-15));
  const Point p = damp(Point(3, -1, 0), Point(7, 2, 0), 2.5, 0.1);
  CHECK(p.x() == once);
  CHECK(p.z() == 0);
}

TEST_CASE("Damping moves nothing in no time, arrives in endless time, and halves the way in ln 2 / rate") {
  CHECK(damp(0.1, 0.7, 3, 0) == 0.1);
  CHECK(damp(0.1, 0.7, 3, 1e6) == 0.7);
  CHECK(damp(0.0, 1.0, 2, std::log(2.0) / 2) == Approx(0.5).epsilon(1e-15));
}

TEST_CASE("A lerp by a tenth in each frame depends on the frame rate: the mistake that damp avoids") {
  const auto left_after_a_second = [](int frames) {
    double x = 0;
    for (int i = 0; i < frames; ++i) x = std::lerp(x, 1.0, 0.1);
    return 1 - x;
  };
  CHECK(left_after_a_second(30) == Approx(0.042).margin(0.0005));
  CHECK(left_after_a_second(60) == Approx(0.0018).margin(0.00005));
}

TEST_CASE("Damping refuses a negative rate and a negative or endless step") {
  CHECK_THROWS_AS(damp(0.0, 1.0, -1, 1), std::invalid_argument);
  CHECK_THROWS_AS(damp(0.0, 1.0, 1, -1), std::invalid_argument);
  CHECK_THROWS_AS(damp(0.0, 1.0, 1, std::numeric_limits<double>::infinity()), std::invalid_argument);
}
