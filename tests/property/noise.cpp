#include <array>
#include <cmath>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/sweep/box_box.hpp"
#include "first_contact/sweep/box_mesh.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

// Where all that a formula subtracts is alike, only rounding is left, and its signs and its quotients say nothing.

using namespace first_contact;

namespace {

/// A whole number from -most to most.
double whole(Chance& chance, int most) {
  return static_cast<double>(chance.pick(static_cast<std::size_t>(2 * most + 1))) - most;
}
Vector tenths(Chance& chance, int most) {
  const double x = whole(chance, most), y = whole(chance, most), z = whole(chance, most);
  return Vector(x, y, z) / 10;
}

/// From a point to the centre of a ball that lies on it: a vector of whole length, in tenths; and that length.
std::pair<Vector, double> on_a_point(Chance& chance) {
  constexpr std::array<std::array<int, 4>, 6> sides{
      {{3, 4, 0, 5}, {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {2, 6, 9, 11}, {6, 6, 7, 11}}};
  const auto& [x, y, z, length] = sides[chance.pick(sides.size())];
  const double times = static_cast<double>(1 + chance.pick(5));
  return {times * Vector(x, y, z) / 10, times * length / 10};
}

/// A ball that lies on a point and goes at right angles to the way there, nearly.
Moving<Sphere> along(Chance& chance, const Point& corner) {
  const auto [off, radius] = on_a_point(chance);
  return {Sphere{corner + off, radius}, off.cross(10 * tenths(chance, 9))};
}

double distance(const Point& p, const Triangle& t) { return norm(p - closest_point(p, t)); }

}  // namespace

TEST_CASE(
    "A ball that lies on a corner of a box and goes along it is not told of a contact where it is not") {
  Chance chance(1);
  for (int i = 0; i < 30000; ++i) {
    const Point corner = tenths(chance, 20);
    const Moving<Sphere> moving = along(chance, corner);
    const Box box(corner - Vector(0.5, 0.5, 0.5), {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    CAPTURE(i);
    if (const auto contact = sweep(moving, box)) {
      const Point center = moving.shape.center + contact->time * moving.displacement;
      const Vector beyond = ((center - box.center).cwiseAbs() - Vector(0.5, 0.5, 0.5)).cwiseMax(0);
      REQUIRE(norm(beyond) <= moving.shape.radius + 1e-12);
    }
  }
}

TEST_CASE(
    "A ball that lies on an edge and goes along it is told the same by triangle, environment and fast tree") {
  Chance chance(2);
  for (int i = 0; i < 20000; ++i) {
    const Point corner = tenths(chance, 20), other = tenths(chance, 20), third = tenths(chance, 20);
    const Mesh mesh({corner, other, third}, {{0, 1, 2}});
    const Point touched = chance.pick(2) ? corner : Point((corner + other) / 2);
    const Moving<Sphere> moving = along(chance, touched);
    const auto contact = sweep(moving, mesh.triangle(0));
    const auto in_environment = sweep(moving, Environment(mesh)), in_tree = sweep(moving, Bvh(mesh));
    CAPTURE(i);
    REQUIRE(in_environment.has_value() == in_tree.has_value());
    if (in_tree) REQUIRE(in_environment->time == in_tree->time);
    if (!contact) continue;
    const Point center = moving.shape.center + contact->time * moving.displacement;
    REQUIRE(distance(center, mesh.triangle(0)) <= moving.shape.radius + 1e-12);
  }
}

TEST_CASE("A point that passes a needle beyond its end does not meet it, whoever is asked") {
  Chance chance(3);
  const double radius = GENERATE(0.0, 1e-18, 1e-14);
  for (int i = 0; i < 30000; ++i) {
    const Point a = tenths(chance, 9);
    const Vector side = tenths(chance, 4);
    // In a line as they are typed: two of them nearly, by the rounding of tenths.
    const Mesh mesh({a, a + whole(chance, 9) / 3 * side, a + whole(chance, 9) / 7 * side}, {{0, 1, 2}});
    const Triangle triangle = mesh.triangle(0);
    const Point aim = a + whole(chance, 9) / 3 * side, start = tenths(chance, 30);
    const Moving<Sphere> moving{Sphere{start, radius}, 2 * (aim - start)};
    const auto contact = sweep(moving, triangle), in_environment = sweep(moving, Environment(mesh)),
               in_tree = sweep(moving, Bvh(mesh));
    CAPTURE(i, radius);
    REQUIRE(in_environment.has_value() == in_tree.has_value());
    if (!contact) continue;
    const Point center = start + contact->time * moving.displacement;
    REQUIRE(distance(center, triangle) <= radius + 1e-13);
  }
}

TEST_CASE("The nearest point of a needle is as near as it is, however thin the needle") {
  Chance chance(4);
  const double height = GENERATE(1e-3, 1e-6, 1e-9);
  for (int i = 0; i < 20000; ++i) {
    const Vector along = chance.direction(), across = along.cross(chance.direction()).normalized();
    const Point a = chance.vector(1);
    const double part = chance.uniform(0, 1);
    const Triangle needle{a, a + along, a + part * along + height * across};
    const double u = chance.uniform(0.05, 0.9), v = chance.uniform(0.05, 0.95 - u);
    const Vector up = along.cross(across);
    const double over = chance.log_uniform(1e-12, 1) * height;
    const Point p = needle.a + u * (needle.b - needle.a) + v * (needle.c - needle.a) + over * up;
    CAPTURE(i, height, over);
    REQUIRE(std::abs(distance(p, needle) - over) <= 1e-14);
    REQUIRE(overlap(Sphere{p, over + 1e-14}, needle));
  }
}

TEST_CASE("The normal at a tiny edge is of length 1, in whatever unit the scene is") {
  const Point centre(-0x1.6bedc2763498p-83, -0x1.38d74978230dp-82, -0x1.10c7ccefa4ac6p-81);
  for (const double unit : {1.0, 0x1p81, 0x1p-81}) {
    const Triangle edge{Point(0, 0, 0), Point(0, 0, unit * 0x1p-150), Point(0, 0, 0)};
    const auto contact =
        sweep(Moving<Sphere>{Sphere{unit * centre, unit * 0x1p-157}, -2 * unit * centre}, edge);
    REQUIRE(contact);
    CHECK(std::abs(norm(contact->normal) - 1) < 1e-15);
    CHECK(std::abs(contact->time - 0.5) < 1e-15);
  }
}

TEST_CASE("Two boxes, or a box and a triangle, meet far from the origin when they meet at the origin") {
  Chance chance(5);
  const double far = GENERATE(1e3, 1e9, 1e15);
  for (int i = 0; i < 2000; ++i) {
    const Vector move =
        std::exp2(std::round(std::log2(far))) * Vector(whole(chance, 3), whole(chance, 3), whole(chance, 3));
    const Vector start = Vector(whole(chance, 4), whole(chance, 4), whole(chance, 4)),
                 sides = chance.vector(0.1);
    const Vector way = -1.5 * start + chance.vector(0.2);
    const auto box = [](const Point& center, const Vector& s) {
      return Box(center, {s.x(), 0, 0}, {0, s.y(), 0}, {0, 0, s.z()});
    };
    const Box still = box({0, 0, 0}, {0.3, 0.2, 0.1}), afar = box(move, {0.3, 0.2, 0.1});
    const auto here = sweep(Moving<Box>(box(start, sides), way), still),
               there = sweep(Moving<Box>(box(start + move, sides), way), afar);
    CAPTURE(i, far);
    REQUIRE(here.has_value() == there.has_value());
    if (here) REQUIRE(here->time == there->time);
    const Triangle face({0, 0, 0}, {1, 0, 0}, {0, 1, 1});
    const Triangle moved(move, Point(move + face.b), Point(move + face.c));
    const auto on_face = sweep(Moving<Box>(box(start, sides), way), face),
               on_moved = sweep(Moving<Box>(box(start + move, sides), way), moved);
    REQUIRE(on_face.has_value() == on_moved.has_value());
    if (on_face) REQUIRE(on_face->time == on_moved->time);
  }
}
