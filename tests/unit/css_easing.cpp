#include "first_contact/motion/css_easing.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "catch.hpp"

using namespace first_contact;
using ease::Jump;

namespace {

double cubic(double a, double b, double u) {
  return 3 * (1 - u) * (1 - u) * u * a + 3 * (1 - u) * u * u * b + u * u * u;
}

}  // namespace

TEST_CASE("A cubic-bezier has the height y(u) where the time is x(u), to the last digits") {
  using Numbers = std::array<double, 4>;
  for (const auto& [x1, y1, x2, y2] :
       {Numbers{0.25, 0.1, 0.25, 1}, Numbers{0.42, 0, 1, 1}, Numbers{0, 0, 0.58, 1},
        Numbers{0.42, 0, 0.58, 1}, Numbers{0, 1.5, 1, 1.5}, Numbers{0.6, -0.5, 0.7, 2}}) {
    const Easing easing = ease::cubic_bezier(x1, y1, x2, y2);
    for (double u = 1 / 64.0; u < 1; u += 1 / 64.0)
      CHECK(easing(cubic(x1, x2, u)) == Approx(cubic(y1, y2, u)).margin(4e-15));
  }
}

TEST_CASE("The style sheets' four easings have their known values") {
  const Easing ease = ease::cubic_bezier(0.25, 0.1, 0.25, 1), in = ease::cubic_bezier(0.42, 0, 1, 1);
  const Easing out = ease::cubic_bezier(0, 0, 0.58, 1), both = ease::cubic_bezier(0.42, 0, 0.58, 1);
  CHECK(ease(0.25) == Approx(0.40851).margin(1e-5));
  CHECK(ease(0.5) == Approx(0.80240).margin(1e-5));
  CHECK(ease(0.75) == Approx(0.96046).margin(1e-5));
  CHECK(both(0.5) == Approx(0.5).margin(1e-15));
  for (double t = 1 / 64.0; t < 1; t += 1 / 64.0) {
    CHECK(out(t) == Approx(1 - in(1 - t)).margin(1e-14));
    CHECK(both(t) == Approx(1 - both(1 - t)).margin(1e-14));
    CHECK(ease::cubic_bezier(0.3, 0.3, 0.8, 0.8)(t) == Approx(t).margin(1e-14));
  }
}

TEST_CASE("A cubic-bezier solves for its parameter also where the curve stands still in time") {
  const Easing steep = ease::cubic_bezier(1, 0, 0, 1);  // x = 1/2 + 4 (u - 1/2)^3, y = 3 u^2 - 2 u^3
  for (const double off : {-0.25, -1e-3, 0.0, 1e-3, 0.25}) {
    const double u = 0.5 + off;
    CHECK(steep(0.5 + 4 * off * off * off) == Approx(3 * u * u - 2 * u * u * u).margin(1e-5));
  }
  CHECK(steep(0.5 + 4 * 0.25 * 0.25 * 0.25) ==
        Approx(3 * 0.75 * 0.75 - 2 * 0.75 * 0.75 * 0.75).margin(1e-15));
}

TEST_CASE("A cubic-bezier that overshoots turns where its height does") {
  const Easing easing = ease::cubic_bezier(0, 1.5, 1, 1.5);  // y' = 0 at u = (3 - root 3)/2 ... within (0, 1)
  REQUIRE(easing.turns().size() == 1);
  double highest = 0;
  for (int i = 0; i <= 100000; ++i) highest = std::max(highest, cubic(1.5, 1.5, i / 100000.0));
  CHECK(easing(easing.turns()[0]) == Approx(highest).epsilon(1e-9));
}

TEST_CASE("Staircases have the outputs of the specification, in and at the beginning of each step") {
  const auto outputs = [](int n, Jump jump) {
    const Easing stairs = ease::steps(n, jump);
    std::vector<double> all;
    for (int i = 0; i < n; ++i) all.push_back(stairs((i + 0.5) / n));
    for (int i = 1; i < n; ++i) CHECK(stairs(double(i) / n) == all[static_cast<std::size_t>(i)]);
    return all;
  };
  using Outputs = std::vector<double>;
  CHECK(outputs(4, Jump::end) == Outputs{0, 0.25, 0.5, 0.75});
  CHECK(outputs(4, Jump::start) == Outputs{0.25, 0.5, 0.75, 1});
  CHECK(outputs(3, Jump::none) == Outputs{0, 0.5, 1});
  CHECK(outputs(3, Jump::both) == Outputs{0.25, 0.5, 0.75});
  CHECK(outputs(1, Jump::both) == Outputs{0.5});
  CHECK(ease::steps(4, Jump::start)(0) == 0);
  CHECK(ease::steps(4, Jump::start)(1e-300) == 0.25);
  CHECK(ease::steps(4)(1) == 1);
  CHECK(ease::steps(5).turns().empty());
}

TEST_CASE("A straight piece whose inputs are so far apart that their difference overflows is as any other") {
  const Easing given = ease::linear_through({{0, -1e308}, {1, 1e308}});
  const Easing filled = ease::linear_through({{0, -1.5e308}, {0.5}, {1, 1.5e308}});
  for (const double t : {0.25, 0.5, 0.75}) {
    CHECK(given(t) == 0.5);
    CHECK(filled(t) == 0.5);
  }
}

TEST_CASE("The largest number of steps is half done after half of the time, wherever it jumps") {
  const int most = std::numeric_limits<int>::max();
  for (const Jump jump : {Jump::start, Jump::end, Jump::none, Jump::both})
    CHECK(ease::steps(most, jump)(0.5) == Approx(0.5).epsilon(2.0 / most));
}

TEST_CASE("linear() spreads the inputs that are left out, and raises those that would go back") {
  const Easing even = ease::linear_through({{0}, {0.25}, {1}});
  CHECK(even(0.5) == 0.25);
  CHECK(even(0.75) == 0.625);
  const Easing rest =
      ease::linear_through({{0}, {0.25, 0.25}, {0.25, 0.75}, {1}});  // linear(0, 0.25 25% 75%, 1)
  CHECK(rest(0.125) == 0.125);
  CHECK(rest(0.6) == 0.25);
  CHECK(rest(0.875) == 0.625);
  const Easing jump = ease::linear_through({{0}, {0.5, 0.5}, {1, 0.25}, {1}});  // the third is raised to 0.5
  CHECK(jump(0.25) == 0.25);
  CHECK(jump(0.5) == 1);
  const Easing bumps = ease::linear_through({{0}, {1, 0.3}, {0.7, 0.301}, {1, 0.302}, {1}});
  for (const double corner : {0.3, 0.301, 0.302})
    CHECK(std::count(bumps.turns().begin(), bumps.turns().end(), corner) == 1);
}

TEST_CASE("What is no easing of a style sheet is refused") {
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(ease::cubic_bezier(1.1, 0, 1, 1), "cubic-bezier's x1 1.1: must be in 0 .. 1");
  CHECK_THROWS_AS(ease::cubic_bezier(0, 0, -0.1, 1), std::invalid_argument);
  CHECK_THROWS_AS(ease::cubic_bezier(0, no_number, 0, 1), std::invalid_argument);
  CHECK_THROWS_WITH(ease::steps(0), "steps 0: must be one or more");
  CHECK_THROWS_AS(ease::steps(1, Jump::none), std::invalid_argument);
  CHECK_THROWS_AS(ease::linear_through({{0}}), std::invalid_argument);
  CHECK_THROWS_AS(ease::linear_through({{0}, {no_number}}), std::invalid_argument);
}
