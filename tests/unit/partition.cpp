#include <cmath>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/objects.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/soup.hpp"

using namespace first_contact;

namespace {

/// Points on a lattice of 2^k by 2^k by 2^k: as even as can be.
std::vector<Bounds> lattice(int k) {
  std::vector<Bounds> points;
  const int side = 1 << k;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        const Point p = Point(x, y, z) / side;
        points.emplace_back(p, p);
      }
  return points;
}

const Triangle floor_tile{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};

std::optional<Contact> drop(double from, double to, const Soup<BspTree>& soup,
                            Statistics* counted = nullptr) {
  return sweep(Moving<Sphere>{{{0, 0, from}, 1}, {0, 0, to - from}}, soup, counted);
}

/// Walls that all look at the middle from around it: a convex room without floor and roof.
std::vector<Triangle> round_room(int walls) {
  std::vector<Triangle> room;
  const auto corner = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / walls;
    return Point(std::cos(angle), std::sin(angle), 0);
  };
  for (int i = 0; i < walls; ++i) room.emplace_back(corner(i), corner(i + 1), corner(i) + Vector(0, 0, 0.1));
  return room;
}

}  // namespace

TEST_CASE("In an octree of k evenly spread objects, one to a leaf, each is log_8 k deep") {
  for (int k = 1; k <= 4; ++k) {
    const Octree tree(lattice(k), OctreeLimits{1, 20});
    CHECK(tree.depth() == static_cast<std::size_t>(k));  // log_8 of 8^k
    CHECK(tree.nodes() == (std::size_t{1} << 3 * (k + 1)) / 7);
  }
}

TEST_CASE("In an octree of clustered objects the depth has nothing to do with log_8 k") {
  std::vector<Bounds> objects;
  for (int i = 0; i < 16; ++i)
    objects.emplace_back(Point::Constant(std::exp2(-i)), Point::Constant(std::exp2(-i)));
  CHECK(Octree(objects, OctreeLimits{1, 20}).depth() == 15);  // log_8 16 = 1.33
  CHECK(Octree(objects, OctreeLimits{1, 6}).depth() == 6);    // the limit holds
}

TEST_CASE(
    "An octree fits two points so closely that one cut parts them, and a third one far away makes it as deep "
    "as "
    "they are close") {
  const auto at = [](const Point& p) { return Bounds(p, p); };
  for (const int n : {3, 10, 20, 30}) {
    const double apart = std::exp2(-n);
    std::vector<Bounds> objects{at(Point::Zero()), at(Point::Constant(apart))};
    CHECK(Octree(objects, OctreeLimits{1, 60}).depth() == 1);
    objects.push_back(at(Point::Constant(1)));
    CHECK(Octree(objects, OctreeLimits{1, 60}).depth() == static_cast<std::size_t>(n));
  }
}

TEST_CASE("An octree of objects in one point is one leaf") {
  const std::vector<Bounds> same(100, bounds_between({1, 2, 3}, {1, 2, 3}));
  CHECK(Octree(same).nodes() == 1);
  CHECK(near(bounds_between({0, 2, 3}, {1, 2, 3}), Objects<Octree>(same)).size() == 100);
}

TEST_CASE("Trees of nothing find nothing") {
  const Moving<Sphere> ball{{{0, 0, 0}, 1}, {1, 0, 0}};
  CHECK_FALSE(sweep(ball, Soup<Octree>({})));
  CHECK_FALSE(sweep(ball, Soup<BspTree>({})));
  CHECK_FALSE(sweep(ball, Soup<BruteForce>({})));
  CHECK(pairs(Objects<Octree>({})).empty());
}

TEST_CASE("A large object among small ones is found from everywhere, and spoils the search nowhere else") {
  auto objects = lattice(3);
  objects.emplace_back(Point(-5, -5, 0.45), Point(5, 5, 0.55));
  const Objects<Octree> room(objects, OctreeLimits{1, 20});
  Statistics counted;
  CHECK(near(bounds_between({4, 4, 0.5}, {4, 4, 0.5}), room, &counted) == std::vector<std::size_t>{512});
  CHECK(counted.tests == 2);  // itself, and the one small object that shares its leaf
}

TEST_CASE("A search in an octree of evenly spread objects tests a few of many") {
  const Objects<Octree> room(lattice(4));
  Statistics counted;
  const Point p(0.5, 0.25, 0.75);
  CHECK(near(Bounds(p, p), room, &counted).size() == 1);
  CHECK(counted.tests <= 8);  // of 4096
}

TEST_CASE(
    "The sphere on one side of a plane at both ends of its motion is not tested against what lies in it") {
  Statistics counted;
  const Soup<BspTree> soup({floor_tile}, BspLimits{0, 64, 16, 8});  // no leaf holds anything
  CHECK_FALSE(drop(3, 1.5, soup, &counted));
  CHECK(counted.tests == 0);
  CHECK_FALSE(drop(-1.5, -3, soup, &counted));
  CHECK(counted.tests == 0);
  CHECK(drop(3, -1, soup, &counted)->time == 0.5);
  CHECK(counted.tests == 1);
}

TEST_CASE(
    "As printed, E.Q >= r at both ends is no contact, and one that touches at the very end is lost by it") {
  const Soup<BspTree> soup({floor_tile}, BspLimits{0, 64, 16, 8});
  const Plane e({0, 0, 1}, 0);
  const Point q1(0, 0, 3), q2(0, 0, 1);
  CHECK((e.signed_distance(q1) >= 1 && e.signed_distance(q2) >= 1));  // the paper's test: no contact
  CHECK(drop(3, 1, soup)->time == 1);                                 // the contract's: first touch at t = 1
}

TEST_CASE("The faces of a convex body all lie behind each other's planes: its BSP tree is a list") {
  const BspTree tree(round_room(40), BspLimits{1, 64, 16, 8});
  CHECK(tree.depth() == 39);
  CHECK(tree.nodes() == 2 * 39 + 1);
}

TEST_CASE("Polygons that all cross each other are not cut without end") {
  std::vector<Triangle> fans;
  for (int i = 0; i < 200; ++i) {
    const Vector u(std::cos(i), std::sin(i), std::cos(2 * i)), v(std::sin(3 * i), std::cos(5 * i), 1);
    fans.emplace_back(u, v, -u - v);
  }
  CHECK(BspTree(fans, BspLimits{1, 64, 16, 8}).order().size() <= 8 * 200);
}

TEST_CASE("Of a polygon that is cut both parts refer to the whole, and it is tested once") {
  const Triangle wall{{0, -1, -1}, {0, 1, -1}, {0, 0, 2}};
  const std::vector<Triangle> cross{floor_tile, wall};
  const Soup<BspTree> soup(cross, BspLimits{0, 64, 1, 8});
  CHECK(soup.tree().order().size() == 3);
  Statistics counted;
  const auto contact = sweep(Moving<Sphere>{{{3, 0.25, 0}, 0.5}, {-6, 0, 0}}, soup, &counted);
  REQUIRE(contact);
  CHECK(counted.tests == 2);
  CHECK(contact->triangle == 0);  // the tile's side, x = 1 - (y + 1) / 2, is before the wall
}

TEST_CASE("Of triangles that are touched at the same time, the face wins, and then the lowest number") {
  const Triangle other{{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}};
  const Triangle at_its_corner{{0, 0, 0}, {1, 0, -1}, {0, 1, -1}};
  const std::vector<Triangle> all{at_its_corner, floor_tile, other};
  const Moving<Sphere> ball{{{0, 0, 3}, 1}, {0, 0, -4}};
  CHECK(sweep(ball, Soup<Octree>(all))->triangle == 1);
  CHECK(sweep(ball, Soup<BspTree>(all))->triangle == 1);
  CHECK(sweep(ball, Soup<BruteForce>(all))->triangle == 1);
}

TEST_CASE(
    "Planes grown by r stick out at a sharp edge to r / sin of half its angle, the tree's last test does "
    "not") {
  const double r = 1;
  for (const double degrees : {90.0, 45.0, 15.0, 5.0}) {
    const double half = 0.5 * degrees * std::numbers::pi / 180;
    // A wedge whose edge is the y axis, opening downwards: two faces that slope away from it.
    const Vector down_right(std::sin(half), 0, -std::cos(half)),
        down_left(-std::sin(half), 0, -std::cos(half));
    const Vector y(0, 8, 0);
    const std::vector<Triangle> wedge{{-y, 8 * down_right, y}, {-y, y, 8 * down_left}};
    const Plane right = Plane::through(Point::Zero(), Vector(std::cos(half), 0, std::sin(half)));

    // Down along the axis: both grown planes are met at the same height, where E.S = r.
    const Moving<Sphere> ball{{{0, 0, 32}, r}, {0, 0, -32}};
    const Plane grown = right.moved_out(r);
    const double t_grown = -grown.signed_distance(ball.shape.center) / grown.normal().dot(ball.displacement);
    const double height_grown = 32 - 32 * t_grown;
    CHECK(height_grown == Approx(r / std::sin(half)));

    const auto contact = sweep(ball, Soup<BspTree>(wedge));
    REQUIRE(contact);
    CHECK(contact->time == Approx(1 - r / 32).epsilon(1e-14));
    CHECK(contact->feature == Feature::edge);
  }
}

TEST_CASE("A soup made from a mesh is the soup of its triangles", "[partition]") {
  const Mesh roof({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 1}}, {{0, 1, 2}, {1, 3, 2}});
  const Soup<BspTree> of_mesh(roof, BspLimits{0, 64, 16, 8}), of_triangles(roof.triangles());
  CHECK(of_mesh.all().size() == 2);
  const Moving<Sphere> ball{{{1.5, 1.5, 3}, 0.25}, {0, 0, -4}};
  CHECK(sweep(ball, of_mesh)->time == sweep(ball, of_triangles)->time);
  CHECK(sweep(ball, of_mesh)->triangle == 1);
}
