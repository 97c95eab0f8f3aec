#include "first_contact/motion/bounce.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch.hpp"

using namespace first_contact;

namespace {

const Bounce paper(25, 50, 9.82, 0.5);
const double forever = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("The paper's ball, physically: it lands after 0.4776 s at 54.69, faster than it was thrown") {
  const auto landing = paper.impact(1);
  REQUIRE(landing);
  CHECK(landing->time == Approx(0.4776).margin(0.00005));
  CHECK(landing->speed == Approx(54.69).margin(0.005));
  CHECK(paper.height(landing->time) == Approx(0).margin(1e-12));
}

TEST_CASE("A ball dropped lands after sqrt(2 h / g) with sqrt(2 g h), and rebounds to e^2 h") {
  const Bounce drop(5, 0, 10, 0.6);
  CHECK(drop.impact(1)->time == Approx(1).epsilon(1e-15));
  CHECK(drop.impact(1)->speed == Approx(10).epsilon(1e-15));
  CHECK(drop.apex(1)->height == Approx(0.36 * 5).epsilon(1e-15));
  CHECK(drop.apex(1)->time == Approx(1.6).epsilon(1e-15));
  CHECK(drop.impact(2)->time == Approx(2.2).epsilon(1e-15));
  CHECK_FALSE(drop.apex(0));
}

TEST_CASE("Thrown up it has a top before its first impact, thrown down it has none") {
  const Bounce up(1, -10, 10, 0.5);
  CHECK(up.apex(0)->time == 1);
  CHECK(up.apex(0)->height == 6);
  CHECK(up.apexes(forever, 2)[0].height == 6);
  CHECK_FALSE(paper.apex(0));
}

TEST_CASE("Speeds are positive downwards") {
  CHECK(paper.speed_down(0) == 50);
  CHECK(Bounce(1, -10, 10, 0.5).height(0.1) > 1);
  CHECK(Bounce(1, 10, 10, 0.5).height(0.05) < 1);
}

TEST_CASE("Each impact leaves e of the speed, and each flight takes e of the time") {
  for (std::size_t n = 1; n < 20; ++n) {
    CHECK(paper.impact(n + 1)->speed == 0.5 * paper.impact(n)->speed);
    if (n > 1)
      CHECK(paper.impact(n + 1)->time - paper.impact(n)->time ==
            Approx(0.5 * (paper.impact(n)->time - paper.impact(n - 1)->time)).epsilon(1e-8));
  }
}

TEST_CASE("Zeno: infinitely many impacts come before the closed-form time of rest") {
  const double rest = *paper.rest_time();
  CHECK(rest == Approx(0.4776 + 2 * 54.69 / 9.82).epsilon(1e-4));
  const auto list = paper.impacts(forever, 1000);
  CHECK(list.size() > 40);
  CHECK(list.size() < 70);
  for (std::size_t i = 1; i < list.size(); ++i) CHECK(list[i].time > list[i - 1].time);
  CHECK(list.back().time <= rest);
  CHECK(list.back().time == Approx(rest).epsilon(1e-14));
  CHECK(paper.height(rest) == 0);
  CHECK(paper.speed_down(rest + 1) == 0);
}

TEST_CASE("With e = 1 it bounces for ever, always to the same height") {
  const Bounce ideal(1, 0, 9.81, 1);
  CHECK_FALSE(ideal.rest_time());
  CHECK(ideal.impacts(60, 1000).size() == 66);
  CHECK(ideal.apex(1000000)->height == Approx(1).epsilon(1e-15));
  CHECK(ideal.impact(1000000)->speed == ideal.impact(1)->speed);
}

TEST_CASE("Energy does not drift: after a minute of bounces at e = 1 it is what it was") {
  const Bounce ideal(1, 0, 9.81, 1);
  for (double t = 0; t < 60; t += 0.0137) {
    const double v = ideal.speed_down(t);
    CHECK(9.81 * ideal.height(t) + v * v / 2 == Approx(9.81).epsilon(2e-14));
  }
}

TEST_CASE("With e = 0 it stays where it lands") {
  const Bounce clay(5, 0, 10, 0);
  CHECK(*clay.rest_time() == clay.impact(1)->time);
  CHECK_FALSE(clay.impact(2));
  CHECK_FALSE(clay.apex(1));
  CHECK(clay.height(1.5) == 0);
  CHECK(clay.impacts(forever, 100).size() == 1);
  CHECK(clay.apexes(forever, 100).empty());
}

TEST_CASE("Without gravity it lands once if thrown down, leaves with e of its speed, and never rests") {
  const Bounce straight(6, 3, 0, 0.5);
  CHECK(straight.impact(1)->time == 2);
  CHECK(straight.impact(1)->speed == 3);
  CHECK_FALSE(straight.impact(2));
  CHECK_FALSE(straight.apex(1));
  CHECK_FALSE(straight.rest_time());
  CHECK(straight.height(4) == 3);
  CHECK(*Bounce(6, 3, 0, 0).rest_time() == 2);
}

TEST_CASE("Without gravity a ball thrown up or let go never lands") {
  CHECK(Bounce(6, -3, 0, 0.5).impacts(forever, 9).empty());
  CHECK(Bounce(6, -3, 0, 0.5).height(10) == 36);
  CHECK_FALSE(Bounce(6, 0, 0, 0.5).impact(1));
  CHECK_FALSE(Bounce(6, 0, 0, 0.5).rest_time());
  CHECK(Bounce(6, 0, 0, 0.5).height(10) == 6);
}

TEST_CASE("A ball that lies on the floor rests there from the start") {
  CHECK(*Bounce(0, 0, 9.81, 0.5).rest_time() == 0);
  CHECK(Bounce(0, 0, 9.81, 1).impacts(forever, 9).empty());
  CHECK(*Bounce(0, 0, 9.81, 1).rest_time() == 0);
  CHECK(Bounce(0, 0, 9.81, 1).height(3) == 0);
}

TEST_CASE("From the floor it lands at once if thrown down, and after its flight if thrown up") {
  CHECK(Bounce(0, 5, 10, 0.5).impact(1)->time == 0);
  CHECK(Bounce(0, 5, 10, 0.5).impact(1)->speed == 5);
  CHECK(Bounce(0, -5, 10, 0.5).impact(1)->time == 1);
}

TEST_CASE("The height is never below the floor, and continuous through the impacts") {
  for (double t = 0; t < 13; t += 0.001) {
    CHECK(paper.height(t) >= 0);
    CHECK(std::abs(paper.height(t + 1e-9) - paper.height(t)) < 1e-7);
  }
  CHECK(paper.height(-1) == 25);
}

TEST_CASE("The list of impacts ends at the time asked for, or at the number asked for") {
  CHECK(paper.impacts(0.4, 100).empty());
  CHECK(paper.impacts(0.5, 100).size() == 1);
  CHECK(paper.impacts(forever, 7).size() == 7);
  CHECK(paper.apexes(forever, 7).size() == 7);
}

TEST_CASE("A scene four times as large and twice as fast has its times doubled, to the last bit") {
  const Bounce large(100, 100, 9.82, 0.5);
  for (std::size_t n = 1; n < 30; ++n) {
    CHECK(large.impact(n)->time == 2 * paper.impact(n)->time);
    CHECK(large.apex(n)->height == 4 * paper.apex(n)->height);
  }
}

TEST_CASE("A bounce refuses values that make no sense, and names them") {
  CHECK_THROWS_AS(Bounce(-1, 0, 9.81, 0.5), std::invalid_argument);
  CHECK_THROWS_AS(Bounce(1, std::nan(""), 9.81, 0.5), std::invalid_argument);
  CHECK_THROWS_AS(Bounce(1, 0, -9.81, 0.5), std::invalid_argument);
  CHECK_THROWS_AS(Bounce(1, 0, 9.81, -0.1), std::invalid_argument);
  CHECK_THROWS_WITH(Bounce(1, 0, 9.81, 1.5), "bounce's restitution 1.5: must be from 0 to 1");
}
