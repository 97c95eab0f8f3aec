#include "first_contact/response/impact.hpp"

#include <cmath>

#include "catch.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"

using namespace first_contact;
using Eigen::Vector2d;

TEST_CASE("Equal masses in an elastic head-on impact exchange their velocities", "[impact]") {
  const auto after = impact<2>({1, {4, 0}}, {1, {-4, 0}}, {-1, 0}, 1);
  CHECK(after.velocity_p == Vector2d(-4, 0));
  CHECK(after.velocity_q == Vector2d(4, 0));
  CHECK(after.impulse == Vector2d(-8, 0));
}

TEST_CASE("Without restitution, head-on bodies go on together with the common velocity", "[impact]") {
  const auto after = impact<3>({3, {4, 0, 0}}, {1, {0, 0, 0}}, {-1, 0, 0}, 0);
  CHECK(after.velocity_p == Vector(3, 0, 0));
  CHECK(after.velocity_q == Vector(3, 0, 0));
}

TEST_CASE("What is across the normal stays as it is", "[impact]") {
  const auto after = impact<2>({5, {1, 7}}, {2, {-1, -3}}, {-1, 0}, 0.5);
  CHECK(after.velocity_p.y() == 7);
  CHECK(after.velocity_q.y() == -3);
}

TEST_CASE("Bodies that part, or slide along each other, are left alone", "[impact]") {
  for (const Vector2d& normal : {Vector2d(1, 0), Vector2d(0, 1)}) {
    const auto after = impact<2>({5, {3, 0}}, {2, {1, 0}}, normal, 1);
    CHECK(after.velocity_p == Vector2d(3, 0));
    CHECK(after.velocity_q == Vector2d(1, 0));
    CHECK(after.impulse == Vector2d(0, 0));
  }
}

TEST_CASE("Two walls of infinite mass may slide along each other, but not meet", "[impact]") {
  const auto after = impact<2>({INFINITY, {3, 0}}, {INFINITY, {1, 0}}, {0, 1}, 1);
  CHECK(after.velocity_p == Vector2d(3, 0));
  CHECK(after.velocity_q == Vector2d(1, 0));
  CHECK_THROWS_WITH(impact<2>({INFINITY, {1, 0}}, {INFINITY, {3, 0}}, {1, 0}, 1),
                    ContainsSubstring("at most one may be infinite"));
}

TEST_CASE("What is not finite in an impact is refused with its numbers", "[impact]") {
  CHECK_THROWS_WITH(Body<2>(1, {INFINITY, 2}), "velocity inf, 2: must be finite");
  CHECK_THROWS_WITH(impact<3>({1, {1, 0, 0}}, {1, {2, 0, 0}}, {0, 0, 0}, 1),
                    "normal 0, 0, 0: must be finite and not zero");
  CHECK_THROWS_WITH(impact<2>({1e300, {-1e300, 0}}, {1e300, {0, 0}}, {1, 0}, 1),
                    "impulse, mass times velocity, inf, 0: must be finite");
}

TEST_CASE("A wall of infinite mass throws a ball back and stays", "[impact]") {
  const auto after = impact<3>({2, {1, 0, -4}}, {INFINITY, {0, 0, 0}}, {0, 0, 1}, 0.75);
  CHECK(after.velocity_p == Vector(1, 0, 3));
  CHECK(after.velocity_q == Vector(0, 0, 0));
  CHECK(after.impulse == Vector(0, 0, 14));
}

TEST_CASE("A moving wall gives twice its speed to a ball at rest", "[impact]") {
  const auto after = impact<2>({1, {0, 0}}, {INFINITY, {3, 0}}, {1, 0}, 1);
  CHECK(after.velocity_p == Vector2d(6, 0));
  CHECK(after.velocity_q == Vector2d(3, 0));
}

TEST_CASE("The length of the normal does not matter", "[impact]") {
  const auto after = impact<2>({1, {1, 1}}, {1, {0, 0}}, {-4, -4}, 1);
  CHECK(after.velocity_p == Vector2d(0, 0));
  CHECK(after.velocity_q == Vector2d(1, 1));
}

TEST_CASE("Bodies, normals and restitutions that mean nothing are refused", "[impact]") {
  CHECK_THROWS_AS((Body<2>{0, {1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS((Body<2>{-1, {1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS((Body<2>{NAN, {1, 1}}), std::invalid_argument);
  CHECK_THROWS_AS((Body<2>{1, {INFINITY, 1}}), std::invalid_argument);
  const Body<2> p{1, {1, 0}}, q{1, {-1, 0}}, wall{INFINITY, {0, 0}}, moving_wall{INFINITY, {1, 0}};
  CHECK_THROWS_AS(impact<2>(p, q, {0, 0}, 1), std::invalid_argument);
  CHECK_THROWS_AS(impact<2>(p, q, {NAN, 0}, 1), std::invalid_argument);
  CHECK_THROWS_AS(impact<2>(p, q, {-1, 0}, 1.5), std::invalid_argument);
  CHECK_THROWS_AS(impact<2>(p, q, {-1, 0}, -0.5), std::invalid_argument);
  CHECK_THROWS_AS(impact<2>(p, q, {-1, 0}, NAN), std::invalid_argument);
  CHECK_THROWS_AS(impact<2>(moving_wall, wall, {-1, 0}, 1), std::invalid_argument);
}

TEST_CASE("The normal is that at contact, not that at the start", "[impact]") {
  // Two unit discs, one aimed 1 = d sin 30 degrees beside the other's centre, from 5 away.
  const Moving<Sphere> p{{{-5, 1, 0}, 1}, {5, 0, 0}};
  const auto contact = sweep(p, Sphere{{0, 0, 0}, 1});
  REQUIRE(contact);
  const auto after = impact<3>({1, p.displacement}, {1, {0, 0, 0}}, contact->normal, 1);
  const auto degrees = [](const Vector& v) { return std::atan2(v.y(), v.x()) * 180 / M_PI; };
  CHECK(degrees(after.velocity_q) == Approx(-30));
  CHECK(degrees(after.velocity_p) == Approx(60));  // equal masses part at a right angle
  const auto at_start = impact<3>({1, p.displacement}, {1, {0, 0, 0}}, p.shape.center, 1);
  CHECK(degrees(at_start.velocity_q) == Approx(-11.309932474));
}

// Numbers that have been got wrong in public; the sources are named.

TEST_CASE("quinton-ashley/p5play PR 51: a ball at 45 degrees comes straight back from a fixed one",
          "[impact][published]") {
  const Moving<Sphere> p{{{200, 200, 0}, 10}, {80, 80, 0}};
  const auto contact = sweep(p, Sphere{{300, 300, 0}, 50});
  REQUIRE(contact);
  CHECK(contact->time == Approx(0.7196699141100894).epsilon(1e-14));
  CHECK(contact->normal.isApprox(Vector(-1, -1, 0).normalized(), 1e-15));
  const auto after = impact<3>({1, p.displacement}, {INFINITY, {0, 0, 0}}, contact->normal, 1);
  CHECK(after.velocity_p.isApprox(Vector(-80, -80, 0), 1e-15));
  CHECK(after.impulse.norm() == Approx(226.27416997969522));
}

TEST_CASE("processing/processing-docs#492: overlapping and separating discs get no impulse",
          "[impact][published]") {
  const Moving<Sphere> p{{{0, 0, 0}, 20}, {-1, 0, 0}}, q{{{30, 0, 0}, 20}, {1, 0, 0}};
  CHECK(overlap(p.shape, q.shape));
  CHECK_FALSE(sweep(p, q));
  const auto after = impact<3>({1, p.displacement}, {1, q.displacement}, {-1, 0, 0}, 1);
  CHECK(after.velocity_p == p.displacement);
  CHECK(after.velocity_q == q.displacement);
}

TEST_CASE("erincatto/solver2d#19: with restitution 1, equal masses do not both stop", "[impact][published]") {
  const Moving<Sphere> p{{{-3, 0, 0}, 1}, {4, 0, 0}}, q{{{3, 0, 0}, 1}, {-4, 0, 0}};
  const auto contact = sweep(p, q);
  REQUIRE(contact);
  CHECK(contact->time == 0.5);
  const auto after = impact<3>({1, p.displacement}, {1, q.displacement}, contact->normal, 1);
  CHECK(after.velocity_p == Vector(-4, 0, 0));
  CHECK(after.velocity_q == Vector(4, 0, 0));
}
