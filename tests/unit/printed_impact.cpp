#include "08_angle_demo/printed_impact.hpp"

#include <cmath>
#include <cstdio>

#include "catch.hpp"
#include "first_contact/response/impact.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;
using Eigen::Vector2d;

namespace {

/// With seven digits, as the paper prints angles.
std::string printed(double degrees) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", degrees);
  return text;
}

Vector in_space(const Vector2d& v) { return {v.x(), v.y(), 0}; }

}  // namespace

TEST_CASE("Program 4, case 1: masses 5:1 go off at 71.56505 and 23.19859 degrees", "[printed_impact]") {
  const auto after = printed_impact({5, {0, 0}, {1, 1}}, {1, {1, 0}, {-1, 1}}, 1);
  CHECK(after.collides);
  CHECK(printed(after.angle[0]) == "71.56505");
  CHECK(printed(after.angle[1]) == "23.19859");
}

TEST_CASE("Program 4, case 2: equal masses go off at exactly 135 and 45 degrees", "[printed_impact]") {
  const auto after = printed_impact({1, {0, 0}, {1, 1}}, {1, {1, 0}, {-1, 1}}, 1);
  CHECK(after.collides);
  CHECK(after.angle[0] == 135);
  CHECK(after.angle[1] == 45);
}

TEST_CASE("Program 4, case 3: with equal velocities there is no collision, at 90 and 90 degrees",
          "[printed_impact]") {
  const auto after = printed_impact({1, {0, 0}, {0, 1}}, {1, {1, 0}, {0, 1}}, 1);
  CHECK_FALSE(after.collides);
  CHECK(after.angle[0] == 90);
  CHECK(after.angle[1] == 90);
}

TEST_CASE("Program 4, case 4: it prints 1.205147 and -102.6519 degrees", "[printed_impact]") {
  const auto after = printed_impact({5, {-1, 8}, {3, -1}}, {1, {0.5, -23}, {-1, 2}}, 1);
  CHECK(after.collides);
  CHECK(printed(after.angle[0]) == "1.205147");
  CHECK(printed(after.angle[1]) == "-102.6519");
}

TEST_CASE("Program 4's case 4 is no collision: discs of radius 1 pass 23.9 apart", "[printed_impact]") {
  const Moving<Sphere> p{{{-1, 8, 0}, 1}, {3, -1, 0}}, q{{{0.5, -23, 0}, 1}, {-1, 2, 0}};
  CHECK_FALSE(contact_interval(p, q));
  const Vector w = p.shape.center - q.shape.center, u = p.displacement - q.displacement;
  const double closest = -w.dot(u) / u.squaredNorm();
  CHECK(closest == Approx(3.96));
  CHECK((w + closest * u).norm() == Approx(23.9));
}

TEST_CASE("Program 4's cases 1 and 2 begin inside each other: distance 1, radii 1 + 1", "[printed_impact]") {
  CHECK(overlap(Sphere{{0, 0, 0}, 1}, Sphere{{1, 0, 0}, 1}));
  CHECK(sweep(Moving<Sphere>{{{0, 0, 0}, 1}, {1, 1, 0}}, Moving<Sphere>{{{1, 0, 0}, 1}, {-1, 1, 0}})->time ==
        0);
}

TEST_CASE("With r = 1, program 4 is the elastic impact with the normal at the start", "[printed_impact]") {
  const PrintedBody one{5, {-1, 8}, {3, -1}}, two{2, {0.5, -23}, {-1, 2}};
  const auto as_printed = printed_impact(one, two, 1);
  const auto exact = impact<2>({5, one.velocity}, {2, two.velocity}, one.position - two.position, 1);
  CHECK(as_printed.velocity[0].isApprox(exact.velocity_p, 1e-14));
  CHECK(as_printed.velocity[1].isApprox(exact.velocity_q, 1e-14));
}

TEST_CASE("With r < 1, program 4 takes speed across the normal as well", "[printed_impact]") {
  const auto as_printed = printed_impact({1, {0, 0}, {1, 1}}, {1, {1, 0}, {-1, -1}}, 0.5);
  const auto exact = impact<2>({1, {1, 1}}, {1, {-1, -1}}, {-1, 0}, 0.5);
  CHECK(as_printed.velocity[0] == Vector2d(-0.5, 0.5));
  CHECK(exact.velocity_p == Vector2d(-0.5, 1));
}

TEST_CASE("Program 4 takes the normal at the start: 11.3 degrees where the discs go off at 30",
          "[printed_impact]") {
  const PrintedBody one{1, {-5, 1}, {5, 0}}, two{1, {0, 0}, {0, 0}};
  CHECK(printed_impact(one, two, 1).angle[1] == Approx(-11.309932474));
  const auto contact =
      sweep(Moving<Sphere>{{in_space(one.position), 1}, in_space(one.velocity)}, Sphere{{0, 0, 0}, 1});
  REQUIRE(contact);
  CHECK(to_degrees(std::atan2(-contact->normal.y(), -contact->normal.x())) == Approx(-30));
}

TEST_CASE("One above the other, program 4 replaces the infinite slope by 10^12", "[printed_impact]") {
  const auto after = printed_impact({1, {0, 0}, {0, 1}}, {1, {0, 2}, {0, -1}}, 1);
  CHECK(after.collides);
  CHECK(after.velocity[0].isApprox(Vector2d(0, -1), 1e-11));
  CHECK_FALSE(after.velocity[0] == Vector2d(0, -1));  // the digits that the guard costs
}

TEST_CASE("Bodies at the same place never collide for program 4: it finds that they do not approach",
          "[printed_impact]") {
  const auto after = printed_impact({1, {2, 3}, {1, 0}}, {1, {2, 3}, {-1, 0}}, 1);
  CHECK_FALSE(after.collides);
  CHECK(after.angle[0] == 0);
  CHECK(after.angle[1] == 180);
}

TEST_CASE("Where its guard underflows, program 4 divides by zero, and the angles are not numbers",
          "[printed_impact]") {
  const auto after = printed_impact({1, {0, 0}, {0, 1}}, {1, {0, 1e-320}, {0, -1}}, 1);
  CHECK(after.collides);
  CHECK(std::isnan(after.angle[0]));
  CHECK(std::isnan(after.angle[1]));
}
