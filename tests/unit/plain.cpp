// What the essays write first, some ten lines each: that it is right, and what breaks it.
#include "01_plane/plain_plane.hpp"
#include "02_box/plain_vertices.hpp"
#include "04_general_sphere/plain_edges.hpp"
#include "04_general_sphere/plain_face.hpp"
#include "04_general_sphere/plain_line.hpp"
#include "04_general_sphere/plain_sweep.hpp"
#include "08_angle_demo/plain_impact.hpp"
#include "catch.hpp"
#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/program/random.hpp"
#include "first_contact/sweep/box_plane.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

using namespace first_contact;

TEST_CASE("A plane as one makes it first is the library's, unless its normal is tiny or huge") {
  std::mt19937 random(18);
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const Vector n = (1 + i) * program::unit_vector(random);
    const double d = program::uniform(random);
    CHECK((plane_chapter::plain_plane(n, d) - Plane(n, d).coefficients()).norm() < 1e-15);
  }
  for (const double size : {1e-200, 1e200}) {
    CHECK_FALSE(std::abs(plane_chapter::plain_plane({0, 0, size}, 0).z()) == 1);
    CHECK(Plane({0, 0, size}, 0).normal().z() == 1);
  }
}

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

TEST_CASE(
    "The triangle as one writes it first is not there for a ball that overlaps it, and the library's at time "
    "0 is") {
  const Triangle triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  const Moving<Sphere> within{{{0, -0.3, 0.1}, 0.2}, {0, 0, -1}};
  CHECK_FALSE(general_sphere_chapter::plain_triangle(within, triangle));
  const auto contact = sweep(within, triangle);
  REQUIRE(contact);
  CHECK(contact->time == 0);
}

TEST_CASE(
    "The triangle as one writes it first loses points at thin triangles, and the library's loses none") {
  std::mt19937 random(9);
  using program::unit_vector;
  int lost = 0;
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const Vector along = unit_vector(random), up = along.cross(unit_vector(random)).normalized();
    const Point a = unit_vector(random), b = a + along;
    const Point c = a + 0.5 * along + 1e-12 * along.cross(up);
    const Moving<Sphere> point{{Point(a + 0.4 * along + up), 0}, -2 * up};
    if (!general_sphere_chapter::plain_triangle(point, {a, b, c})) ++lost;
    CHECK(sweep(point, Triangle{a, b, c}).has_value());
  }
  CHECK(lost > 50);
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

TEST_CASE("A line through a triangle, as one writes it first, is the library's where the triangle is near") {
  std::mt19937 random(16);
  using program::unit_vector;
  int met = 0;
  for (int i = 0; i < 10000; ++i) {
    CAPTURE(i);
    const Vector v = unit_vector(random), a = unit_vector(random), b = unit_vector(random),
                 c = unit_vector(random);
    const bool meets = general_sphere_chapter::plain_line_meets(v, a, b, c);
    REQUIRE(meets == weights_where_line_meets(v, a, b, c).has_value());
    met += meets;
  }
  CHECK(met > 1000);
  CHECK(met < 9000);
}

TEST_CASE("A line through a shared edge, as one writes it first, meets one of the triangles at least") {
  std::mt19937 random(17);
  using program::unit_vector;
  for (int i = 0; i < 10000; ++i) {
    CAPTURE(i);
    const Vector a = unit_vector(random), b = unit_vector(random), out = unit_vector(random);
    const Vector v = a + (0.5 + 0.4 * program::uniform(random)) * (b - a);
    const bool left = general_sphere_chapter::plain_line_meets(v, a, b, v + out);
    const bool right = general_sphere_chapter::plain_line_meets(v, b, a, v - out);
    REQUIRE((left || right));
  }
}

TEST_CASE(
    "From a hundred million sides a line as one writes it first misses triangles, and the library's none") {
  const auto far = general_sphere_chapter::lines_from(1e8), near = general_sphere_chapter::lines_from(10);
  CHECK(far.missed > far.lines / 10);
  CHECK(far.missed_by_library == 0);
  CHECK(near.missed == 0);
}

TEST_CASE("Ridge, valley and seam as one writes them first are right for a solid that stands upright") {
  const Vector up(0, 0, 1), right(1, 0, 0), along(0, 1, 0);
  CHECK(general_sphere_chapter::plain_kind(up, right, along) == EdgeKind::convex);
  CHECK(general_sphere_chapter::plain_kind(up, -right, along) == EdgeKind::concave);
  CHECK(general_sphere_chapter::plain_kind(up, up, along) == EdgeKind::flat);
}

TEST_CASE(
    "A buried vertex as one writes it first: in a floor, in a saddle, and not at the corner of a cube") {
  const Vector x(1, 0, 0), y(0, 1, 0), up(0, 0, 1);
  CHECK(general_sphere_chapter::plain_buried({x, y, -x, -y}));
  CHECK(general_sphere_chapter::plain_buried({x + up, y - up, -x + up, -y - up}));
  CHECK_FALSE(general_sphere_chapter::plain_buried({-x, -y, -up}));
  CHECK_FALSE(buried_by({-x, -y, -up}));
}

TEST_CASE(
    "A solid that is turned has seams that are felt and corners that are buried, as one writes them first") {
  const auto solids = general_sphere_chapter::turned_solids(100);
  CHECK(solids.seams == 900);  // so many the library finds flat: all of them
  CHECK(solids.seams_felt > 450);
  CHECK(solids.corners == 1000);
  CHECK(solids.corners_buried > 200);
}

TEST_CASE("A corner of a sheet is buried as one writes it first, and not for the library") {
  const Vector x(1, 0, 0), y(0, 1, 0);
  CHECK(general_sphere_chapter::plain_buried({x, y}));
  CHECK_FALSE(buried_by({x, y}));
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
