#include "first_contact/sweep/obstacle.hpp"

#include "catch.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/response/slide.hpp"
#include "first_contact/sweep/ray_triangle.hpp"
#include "first_contact/sweep/sphere_box.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_plane.hpp"
#include "first_contact/sweep/sphere_sphere.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/soup.hpp"
#include "room.hpp"
#include "test_meshes.hpp"

using namespace first_contact;

namespace {

static_assert(Obstacle<Plane> && Obstacle<Triangle> && Obstacle<Box> && Obstacle<Sphere>);
static_assert(Obstacle<Moving<Sphere>> && Obstacle<Environment> && Obstacle<Bvh> && Obstacle<Soup<Octree>>);
static_assert(Obstacle<Plane, Point> && Obstacle<Bvh, Point> && Obstacle<Moving<Sphere>, Point>);
static_assert(Obstacle<Room> && !Obstacle<int> && !Obstacle<Point>);

const Mesh floor_mesh = test_meshes::tiled_floor(4);

/// Calls with the floor z = 0 in each of the ways to describe it.
template <class Call>
void for_each_floor(const Call& call) {
  call(Plane{{0, 0, 1}, 0});
  call(Triangle{{-20, -20, 0}, {40, -20, 0}, {0, 40, 0}});
  call(Box{{2, 2, -0.5}, {4, 0, 0}, {0, 4, 0}, {0, 0, 1}});
  call(Environment(floor_mesh));
  call(Bvh(Mesh(floor_mesh)));
  call(Soup<Octree>(floor_mesh));
  call(Room{{Plane{{0, 0, 1}, 0}}});
}

}  // namespace

TEST_CASE("A moving shape is named once: its type follows") {
  const Moving ball{Sphere{Point(0, 0, 3), 1}, Vector(0, 0, -4)};
  const Moving point{Point(0, 0, 1) + Point(0, 0, 2), Vector(0, 0, -4)};
  static_assert(std::same_as<decltype(ball), const Moving<Sphere>>);
  static_assert(std::same_as<decltype(point), const Moving<Point>>);
  CHECK(point.shape == ball.shape.center);
}

TEST_CASE("A floor is a floor, whatever it is made of: for a sphere, for a point, and for a slide along it") {
  for_each_floor([](const auto& ground) {
    const auto ball = sweep(Moving{Sphere{Point(1.25, 2, 3), 1}, Vector(0, 0, -4)}, ground);
    REQUIRE(ball);
    CHECK(ball->time == 0.5);
    CHECK(ball->normal == Vector(0, 0, 1));
    CHECK((ball->point() - Point(1.25, 2, 0)).norm() < 1e-15);
    const auto point = sweep(Moving{Point(1.25, 2, 2), Vector(0, 0, -4)}, ground);
    REQUIRE(point);
    CHECK(point->time == 0.5);
    CHECK_FALSE(sweep(Moving{Point(1.25, 2, 2), Vector(0.5, 0, 0)}, ground));
    const Slide path = slide(Moving{Sphere{Point(1, 2, 1.5), 1}, Vector(1, 0.5, -1)}, ground);
    const double gap = slide_gap * (4 + largest_coordinate(ground));  // about how far it keeps off
    CHECK((path.end() - Point(2, 2.5, 1)).norm() < 4 * gap);
  });
}

TEST_CASE("A ball slides over a ball at rest as over any wall") {
  const Slide path = slide(Moving{Sphere{Point(0, 0, 3), 1}, Vector(0.5, 0, -2)}, Sphere{Point(0, 0, 0), 1});
  CHECK(path.contacts.size() >= 1);
  CHECK(path.end().norm() >= 2);
  CHECK(path.end().x() > 0);
}

TEST_CASE("A point overlaps what it lies on") {
  CHECK(overlap(Point(1, 2, 0), Plane{{0, 0, 1}, 0}));
  CHECK(overlap(Point(1, 2, 0), Environment(floor_mesh)));
  CHECK_FALSE(overlap(Point(1, 2, 0.25), Environment(floor_mesh)));
  CHECK(overlap(Point(0, 0, 1), Sphere{Point(0, 0, 0), 1}));
}

TEST_CASE("The largest coordinate of an obstacle is that of what it is made of") {
  CHECK(largest_coordinate(Plane{{0, 0, 2}, 6}) == 3);
  CHECK(largest_coordinate(Sphere{{1, -2, 0.5}, 4}) == 4);
  CHECK(largest_coordinate(Sphere{{1, -7, 0.5}, 4}) == 7);
  CHECK(largest_coordinate(Box{{1, 0, 0}, {2, 0, 0}, {0, 8, 0}, {0, 0, 2}}) == 4);
  CHECK(largest_coordinate(Triangle{{1, 2, 3}, {0, -9, 0}, {0, 0, 0}}) == 9);
  CHECK(largest_coordinate(floor_mesh) == 4);
  CHECK(largest_coordinate(Bvh(Mesh(floor_mesh))) == 4);
  CHECK(largest_coordinate(Soup<Octree>(floor_mesh)) == 4);
  CHECK(largest_coordinate(Mesh({}, {})) == 0);
}
