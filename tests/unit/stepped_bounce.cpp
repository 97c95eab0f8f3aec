#include "07_tween_bounce/stepped_bounce.hpp"

#include <algorithm>
#include <stdexcept>

#include "catch.hpp"

using namespace first_contact;

namespace {

// The highest point of the last two seconds of a minute at 60 pictures a second; dropped from 1, restitution
// 1.
double late_peak(Stepper stepper) {
  const auto states = stepped_bounce(stepper, 1, 9.81, 1, 1.0 / 60, 3600);
  const auto higher = [](const Stepped& a, const Stepped& b) { return a.height < b.height; };
  return std::max_element(states.end() - 180, states.end(), higher)->height;
}

}  // namespace

TEST_CASE("Explicit Euler steps make a ball that should bounce to 1 bounce to 9.5 after a minute") {
  CHECK(late_peak(Stepper::explicit_euler) == Approx(9.5).margin(0.3));
}
TEST_CASE("Semi-implicit Euler steps keep it near 0.9") {
  CHECK(late_peak(Stepper::semi_implicit_euler) == Approx(0.88).margin(0.1));
}
TEST_CASE("Exact parabolas with the impact a step late still make it bounce to 3.7") {
  CHECK(late_peak(Stepper::parabola) == Approx(3.7).margin(0.3));
}

TEST_CASE("Between impacts a parabola step is exact") {
  const auto states = stepped_bounce(Stepper::parabola, 5, 10, 1, 0.125, 7);
  CHECK(states.back().height == Approx(5 - 5 * 0.875 * 0.875).epsilon(1e-15));
  CHECK(states.back().energy(10) == Approx(50).epsilon(1e-15));
}

TEST_CASE("A stepped bounce refuses values that make no sense") {
  CHECK_THROWS_AS(stepped_bounce(Stepper::parabola, -1, 10, 1, 0.1, 7), std::invalid_argument);
  CHECK_THROWS_AS(stepped_bounce(Stepper::parabola, 1, -10, 1, 0.1, 7), std::invalid_argument);
  CHECK_THROWS_AS(stepped_bounce(Stepper::parabola, 1, 10, 2, 0.1, 7), std::invalid_argument);
  CHECK_THROWS_AS(stepped_bounce(Stepper::parabola, 1, 10, 1, 0, 7), std::invalid_argument);
}
