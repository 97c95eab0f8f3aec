#include "first_contact/sweep/turning_mesh.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "first_contact/geometry/triangle_distance.hpp"

using namespace first_contact;

namespace {

constexpr double pi = std::numbers::pi;

// A bar from the hinge along x, and a wall at right angles to y.
const Mesh bar({{0, 0, 0}, {2, 0, 0}, {2, 0, 0.1}}, {{0, 1, 2}});

Mesh wall(double y) { return {{{-9, y, -9}, {9, y, -9}, {0, y, 9}}, {{0, 1, 2}}}; }

std::optional<Contact> turn(const Mesh& mover, const Mesh& obstacle, double angle) {
  return sweep(Turning<Mesh>(mover, {0, 0, 0}, {0, 0, 1}, angle), obstacle);
}

double distance(const Mesh& a, const Mesh& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      least = std::min(least, nearest_points(a.triangle(i), b.triangle(j)).distance());
  return least;
}

}  // namespace

TEST_CASE("A bar of length 2 that turns meets a wall at distance 1 at 30 degrees") {
  const auto contact = turn(bar, wall(1), pi / 2);
  REQUIRE(contact);
  const double angle = contact->time * pi / 2;
  CHECK(angle <= pi / 6 + 1e-15);
  CHECK(pi / 6 - angle <
        9 * turning_gap * 18);  // the scene reaches 13 units; the end rises by sqrt(3) a radian
  CHECK((contact->point() - Point(std::sqrt(3.0), 1, 0)).norm() < 0.2);
  CHECK((contact->normal - Vector(0, -1, 0)).norm() < 1e-6);
  CHECK(contact->feature == Feature::face);
}

TEST_CASE("A bar that is too short for the wall turns all round without a contact") {
  CHECK_FALSE(turn(bar, wall(2.001), 2 * pi));
  CHECK(turn(bar, wall(1.999), 2 * pi));
}

TEST_CASE("A bar does not turn through a wall as thin as a triangle, however far it turns") {
  const auto contact = turn(bar, wall(1), 2 * pi);
  REQUIRE(contact);
  CHECK(contact->time * 2 * pi == Approx(pi / 6).epsilon(1e-5));
}

TEST_CASE("A bar that turns the other way meets the wall from the other side") {
  const auto contact = turn(bar, wall(1), -2 * pi);
  REQUIRE(contact);
  CHECK(contact->time * 2 * pi == Approx(5 * pi / 6 + pi / 3).epsilon(1e-5));
  CHECK((contact->normal - Vector(0, -1, 0)).norm() < 1e-6);
}

TEST_CASE("Without a turn there is no contact, and what touches at the start is in contact at 0") {
  CHECK_FALSE(turn(bar, wall(0), 0));
  CHECK(turn(bar, wall(0), 1)->time == 0);
}

TEST_CASE("A turn in a scene scaled by a power of two has the same time, bit by bit") {
  const auto scaled = [](const Mesh& mesh, double factor) {
    std::vector<Point> vertices;
    for (const Point& p : mesh.vertices()) vertices.emplace_back(factor * p);
    return Mesh(vertices, mesh.faces());
  };
  const double time = turn(bar, wall(1), 2)->time;
  for (const double factor : {0x1p-40, 0x1p-3, 0x1p30})
    CHECK(turn(scaled(bar, factor), scaled(wall(1), factor), 2)->time == time);
}

TEST_CASE("Before the first contact of a turn dense sampling finds none, and at it the gap is closed") {
  for (int seed = 0; seed < 40; ++seed) {
    std::srand(static_cast<unsigned>(seed));
    const auto triangle = [](double away) {
      const Point middle = away * Vector::Random();
      return Mesh({middle + Vector::Random(), middle + Vector::Random(), middle + Vector::Random()},
                  {{0, 1, 2}});
    };
    const Mesh obstacle = triangle(3);
    const Turning<Mesh> turning(triangle(3), {0, 0, 0}, Vector::Random(), 3);
    const auto contact = sweep(turning, obstacle);
    const double reach = 10, near = turning_gap * reach;
    const double until = contact ? contact->time : 1;
    CAPTURE(seed, until);
    for (int i = 0; i < 200; ++i)  // nothing before it
      REQUIRE(distance(turned(turning, until * i / 200), obstacle) > 0);
    if (contact) CHECK(distance(turned(turning, until), obstacle) <= near);
  }
}

// By its speed alone, a step would be as short as the distance.
TEST_CASE(
    "A lid that turns on its box, and a drawer in its case, keep their distance at the price of few steps") {
  const Box below({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  for (const double above : {1e-3, 1e-6, 2e-7}) {
    const Box lid({0, 0, 1 + above}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    CAPTURE(above);
    CHECK_FALSE(sweep(Turning<Box>(lid, {0, 0, 0}, {0, 0, 1}, 2 * pi), below));
    CHECK_FALSE(sweep(Turning<Box>(lid, {0.3, 2, 0}, {0, 0, -1}, 3, {0.2, -3, 0}), below));
    CHECK_FALSE(sweep(Turning<Box>(lid, {0, 0, 0}, {0, 0, 1}, 0, {3, 0.1, 0}), below));
  }
}

// Askew, so that the difference of two near points has an error of 10^-5 of it: the normal must come from the features.
TEST_CASE(
    "A lid within the gap that turns on its box touches it, if at all, after the start and before the end") {
  const Vector r = Vector(1, 2, 2) / 3, s = Vector(2, 1, -2) / 3, n = Vector(2, -2, 1) / 3;
  for (const double above : {3e-8, 1e-8, 1e-9, 1e-10, 1e-11})
    for (const double turned_by : {0.0, 0.6}) {
      const double c = std::cos(turned_by), d = std::sin(turned_by);
      const Box below({0, 0, 0}, r, s, n), lid((1 + above) * n, c * r + d * s, c * s - d * r, n);
      const auto contact = sweep(Turning<Box>(lid, {0, 0, 0}, n, 7), below);
      CAPTURE(above, turned_by);
      if (contact) CHECK((contact->time > 0 && contact->time < 1));
    }
}

TEST_CASE("A lid that sinks as it turns touches when it has sunk to its box, whichever way it turns") {
  const Box below({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const Box lid({0, 0, 1.5}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  for (const double angle : {-100.0, -3.0, 0.0, 0.1, 7.0}) {
    const auto contact = sweep(Turning<Box>(lid, {0, 0, 0}, {0, 0, 1}, angle, {0, 0, -1}), below);
    CAPTURE(angle);
    REQUIRE(contact);
    CHECK(contact->time <= 0.5);
    CHECK(contact->time >= 0.5 - 3 * turning_gap);
    CHECK((contact->normal - Vector(0, 0, 1)).norm() < 1e-6);
  }
}

TEST_CASE("An axis without direction and an angle that is infinite, or more than 1e6, are refused") {
  CHECK_THROWS_WITH(Turning<Mesh>(bar, {0, 0, 0}, {0, 0, 1}, 1e300),
                    "angle 1e+300: must be at most 1e6 in size");
  CHECK_THROWS_AS(Turning<Mesh>(bar, {0, 0, 0}, {0, 0, 0}, 1), std::invalid_argument);
  CHECK_THROWS_AS(Turning<Mesh>(bar, {0, 0, 0}, {0, 0, 1}, INFINITY), std::invalid_argument);
}

TEST_CASE(
    "The surface of a box has its area and holds its volume, its triangles seen from outside, mirrored or "
    "not") {
  for (const double mirrored : {1.0, -1.0}) {
    const Mesh mesh = surface_of(Box({5, 6, 7}, {2 * mirrored, 0, 0}, {0, 3, 0}, {0, 0, 4}));
    Vector area = Vector::Zero();  // of the sides across each axis
    double volume = 0;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      const Triangle t = mesh.triangle(i);
      area += t.area_vector().cwiseAbs() / 2;
      volume += t.a.dot(t.area_vector()) / 6;
      CHECK((t.area_vector().array() != 0).count() == 1);
    }
    CHECK(area == Vector(24, 16, 12));
    CHECK(volume == Approx(24));
  }
}

TEST_CASE(
    "Two triangles are as near as corner and face, edge and edge, or not apart at all where they cross") {
  const Triangle flat({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  CHECK(nearest_points(flat, Triangle({1, 1, 2}, {1, 2, 5}, {2, 1, 5})).distance() == 2);
  CHECK(nearest_points(flat, Triangle({2, -1, 1}, {2, -1, -1}, {2, -5, 0})).distance() == 1);
  CHECK(nearest_points(flat, Triangle({1, 1, 1}, {1, 1, -1}, {1.5, 1, -1})).distance() == 0);
  CHECK(nearest_points(flat, Triangle({5, 0, 0}, {6, 0, 0}, {7, 0, 0})).distance() == 1);
}
