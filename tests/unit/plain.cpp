// What the essays write first, some ten lines each: that it is right, and what breaks it.
#include "02_box/plain_vertices.hpp"
#include "04_general_sphere/plain_face.hpp"
#include "04_general_sphere/plain_sweep.hpp"
#include "08_angle_demo/plain_impact.hpp"
#include "catch.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/program/random.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;

TEST_CASE(
    "The lowest vertices as one writes them first are the library's while an axis is level exactly or not at "
    "all") {
  std::mt19937 random(6);
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const double turn = 3.1 * program::uniform(random);
    const Vector axis = i % 2 == 0 ? Vector(0, 0, 1) : program::unit_vector(random);
    const Box box = Rigid::turned(axis, turn).box({{1, 2, 3}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}});
    const Vector up(0, 0, 1);
    const auto plain = box_chapter::plain_vertices(box, up);
    const ContactPoints points = lowest_vertices(box, up);
    REQUIRE(plain.size() == static_cast<std::size_t>(points.cols()));
    for (const Point& p : plain) CHECK((points.colwise() - p).colwise().norm().minCoeff() < 1e-12);
  }
}

TEST_CASE("The lowest vertices as one writes them first are too few when box and floor are turned together") {
  const Rigid turn(Eigen::Quaterniond(1, 2, 3, 4), {0, 0, 0});
  const Box brick = turn.box({{0, 0, 0}, {1.8, 0, 0}, {0, 1.2, 0}, {0, 0, 0.9}});
  const Vector normal = turn.plane(Plane({0, 0, 1}, 0)).normal();
  CHECK(box_chapter::plain_vertices(brick, normal).size() == 1);
  CHECK(lowest_vertices(brick, normal).cols() == 4);
}

TEST_CASE("The face as one writes it first agrees with the library's where triangles are ordinary") {
  std::mt19937 random(7);
  using program::unit_vector;
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    const Triangle triangle{unit_vector(random), unit_vector(random), unit_vector(random)};
    const Point start = 3 * unit_vector(random), target = unit_vector(random);
    const Moving<Sphere> ball{{start, 0.4}, 1.5 * (target - start)};
    const auto plain = general_sphere_chapter::plain_face(ball, triangle);
    if (!plain) continue;
    ++hits;
    const auto touch = touch_face(ball, Facet(triangle));
    REQUIRE(touch);
    CHECK(touch->time == Approx(*plain).margin(1e-9));
  }
  CHECK(hits > 100);
}

TEST_CASE("The face as one writes it first is not there for a ball from behind, and is for the library's") {
  const Triangle triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  const Moving<Sphere> from_behind{{{0, 0, -3}, 0.5}, {0, 0, 4}};
  CHECK_FALSE(general_sphere_chapter::plain_face(from_behind, triangle));
  CHECK(touch_face(from_behind, Facet(triangle))->time == Approx(2.5 / 4));
}

TEST_CASE("The triangle as one writes it first agrees with the library's where nothing is extraordinary") {
  std::mt19937 random(8);
  using program::unit_vector;
  int hits = 0, passes = 0;
  for (int i = 0; i < 20000; ++i) {
    CAPTURE(i);
    Triangle triangle{unit_vector(random), unit_vector(random), unit_vector(random)};
    const Point start = 3 * unit_vector(random), target = unit_vector(random);
    if (dot((triangle.b - triangle.a).cross(triangle.c - triangle.a), start - triangle.a) < 0)
      std::swap(triangle.b, triangle.c);
    const Moving<Sphere> ball{{start, 0.4}, 1.5 * (target - start)};
    const auto plain = general_sphere_chapter::plain_triangle(ball, triangle);
    const auto contact = sweep(ball, triangle);
    REQUIRE(plain.has_value() == contact.has_value());
    if (plain) CHECK(contact->time == Approx(*plain).margin(1e-9));
    ++(plain ? hits : passes);
  }
  CHECK(hits > 5000);
  CHECK(passes > 1000);
}

TEST_CASE("The root as one writes it first loses hits from a hundred million radii, and the library's none") {
  std::mt19937 random(9);
  using program::unit_vector;
  int lost = 0;
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const Vector m = 1e8 * unit_vector(random), v = 2 * (0.9 * unit_vector(random) - m);
    if (!general_sphere_chapter::plain_root(m, v, 1)) ++lost;
    REQUIRE(touch_vertex({{m, 1}, v}, Point(0, 0, 0)));
  }
  CHECK(lost > 10);
}

TEST_CASE("The impact as one writes it first is the library's along a normal of length 1") {
  std::mt19937 random(10);
  using program::unit_vector;
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const Body<3> p(1 + program::uniform(random) / 2, unit_vector(random));
    const Body<3> q(i % 2 == 0 ? 3 : std::numeric_limits<double>::infinity(), unit_vector(random));
    const Vector normal = unit_vector(random);
    const auto [after_p, after_q] = angle_demo_chapter::plain_impact(p, q, normal, 0.5);
    const Impact<3> after = impact<3>(p, q, normal, 0.5);
    CHECK((after_p - after.velocity_p).norm() < 1e-13);
    CHECK((after_q - after.velocity_q).norm() < 1e-13);
  }
}

TEST_CASE("With a normal twice as long the impact as one writes it first changes velocities fourfold") {
  const Body<3> p(1, Vector(-1, 0, 0)), q(1, Vector(0, 0, 0));
  CHECK(angle_demo_chapter::plain_impact(p, q, Vector(1, 0, 0), 1).second == Vector(-1, 0, 0));
  CHECK(angle_demo_chapter::plain_impact(p, q, Vector(2, 0, 0), 1).second == Vector(-4, 0, 0));
  CHECK(impact<3>(p, q, Vector(2, 0, 0), 1).velocity_q == Vector(-1, 0, 0));
}
