// What the essays claim of rounding and of costs, and show by a measurement of their own.
#include <algorithm>
#include <numeric>

#include "02_box/plain_vertices.hpp"
#include "03_partitioning/plain_tree.hpp"
#include "04_general_sphere/plain_face.hpp"
#include "04_general_sphere/plain_sweep.hpp"
#include "04_general_sphere/seam.hpp"
#include "06_moving_spheres/nearly_touching.hpp"
#include "07_tween_bounce/plain_sweep_along.hpp"
#include "08_angle_demo/plain_impact.hpp"
#include "catch.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/program/counted.hpp"
#include "first_contact/program/random.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/contact_times.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;
using program::Counted;

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

TEST_CASE("At a flat seam no point slips between two faces, but balls do, and the edge stops them") {
  const auto points = general_sphere_chapter::shots_at_a_seam(0);
  CHECK(points.both_faces_missed == 0);
  const auto balls = general_sphere_chapter::shots_at_a_seam(1);
  CHECK(balls.both_faces_missed > balls.balls / 100);
  CHECK(balls.missed == 0);
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

TEST_CASE(
    "When spheres nearly touch, the product of the roots is better by a factor, and both ways err as one "
    "over the gap") {
  const NearErrors near = nearly_touching(1e-3), nearer = nearly_touching(1e-4);
  CHECK(near.by_product < near.by_difference);
  CHECK(nearer.by_product / near.by_product == Approx(10).epsilon(0.5));
  CHECK(nearer.by_difference / near.by_difference == Approx(10).epsilon(0.5));
}

TEST_CASE(
    "By the product of the roots, spheres that are found apart and meet have their contact in the future") {
  for (int i = 1; i < 1000; ++i) {
    const Vector3<float> w(1 + 1e-7F * static_cast<float>(i), 1e-3F, 0),
        u(-1, 0.1F * static_cast<float>(i % 7), 0);
    const auto times = contact_times(w, u, 1.0F);
    if (w.squaredNorm() > 1 && times) CHECK(times->begin > 0);
  }
}

TEST_CASE(
    "A curve swept by a few chords, as one writes it first, comes nearer to its contact with more of them") {
  const Bezier down({{0, 0, 3}, {1, 0, 2}, {2, 0, -4}});
  const Plane floor({0, 0, 1}, 0);
  const double time = sweep_along(Curve(down), 0.5, floor, 1e-8)->time;
  const auto error = [&](int chords) {
    return std::abs(*tween_bounce::plain_sweep_along(Curve(down), 0.5, floor, chords) - time);
  };
  CHECK(error(4) > 1e-3);
  CHECK(error(64) < 1e-4);
}

TEST_CASE("A curve swept by a few chords, as one writes it first, loses a dip between two of their ends") {
  const Bezier dip({{0, 0, 2}, {1, 0, -1.2}, {2, 0, 2}});  // as low as 0.4
  const Plane floor({0, 0, 1}, 0);
  CHECK_FALSE(tween_bounce::plain_sweep_along(Curve(dip), 0.5, floor, 3));
  CHECK(sweep_along(Curve(dip), 0.5, floor, 1e-8)->time == Approx(0.5 - std::sqrt(0.1 / 6.4)).margin(1e-6));
}

TEST_CASE("The tree as one writes it first finds all that a ball touches, and not much that it does not") {
  std::mt19937 random(11);
  using program::unit_vector;
  std::vector<Triangle> triangles;
  std::vector<Bounds> bounds;
  for (int i = 0; i < 500; ++i) {
    const Point at = 5 * unit_vector(random);
    triangles.push_back({at, at + 0.3 * unit_vector(random), at + 0.3 * unit_vector(random)});
    bounds.push_back(bounds_of(triangles.back()));
  }
  std::vector<std::size_t> things(triangles.size());
  std::iota(things.begin(), things.end(), std::size_t{0});
  const auto tree = partitioning_chapter::plain_tree(bounds, things);
  std::size_t tests = 0;
  int touched = 0;
  for (int i = 0; i < 500; ++i) {
    CAPTURE(i);
    const Moving<Sphere> ball{{6 * unit_vector(random), 0.2}, 6 * unit_vector(random)};
    const auto found = partitioning_chapter::plain_search(tree, ball);
    tests += found.size();
    for (const std::size_t k : things) {
      if (!sweep(ball, triangles[k])) continue;
      ++touched;
      REQUIRE(std::count(found.begin(), found.end(), k) == 1);
    }
  }
  CHECK(touched > 100);
  CHECK(tests < 500 * triangles.size() / 5);
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

TEST_CASE("A number that counts computes as a double does, and counts each operation once") {
  const Vector3<Counted> w(-3, 1, 0), u(2, 0, 1);
  std::optional<ContactTimes<Counted>> times;
  const program::Operations done = Counted::in([&] { times = contact_times<Counted>(w, u, 2); });
  const auto plain = contact_times<double>({-3, 1, 0}, {2, 0, 1}, 2);
  CHECK(times->begin.value() == plain->begin);
  CHECK(times->end.value() == plain->end);
  CHECK(done.divisions == 2);
  CHECK(done.roots == 1);
  CHECK(Counted::in([&] { return w.dot(u); }).multiplications == 3);
  CHECK(Counted::in([&] { return w.dot(u); }).additions == 2);
}
