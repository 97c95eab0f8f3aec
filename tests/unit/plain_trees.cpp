// The trees that the essays write first, some ten lines each: that they are right, and what breaks them.
#include <algorithm>
#include <numeric>

#include "03_partitioning/plain_bsp.hpp"
#include "03_partitioning/plain_octree.hpp"
#include "catch.hpp"
#include "first_contact/program/random.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/soup.hpp"

using namespace first_contact;

namespace {

// Small triangles about the origin, as far away as 5.
std::vector<Triangle> splinters(int count, std::mt19937& random) {
  using program::unit_vector;
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Point at = 5 * unit_vector(random);
    triangles.emplace_back(at, at + 0.3 * unit_vector(random), at + 0.3 * unit_vector(random));
  }
  return triangles;
}

std::vector<std::size_t> numbers_to(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

// A flight among them.
Moving<Sphere> flight(std::mt19937& random) {
  return {{6 * program::unit_vector(random), 0.2}, 6 * program::unit_vector(random)};
}

}  // namespace

TEST_CASE(
    "The tree of boxes as one writes it first finds all that a ball touches, and not much that it does not") {
  std::mt19937 random(11);
  const auto triangles = splinters(500, random);
  std::vector<Bounds> bounds;
  for (const Triangle& triangle : triangles) bounds.push_back(bounds_of(triangle));
  const auto things = numbers_to(triangles.size());
  const auto tree = partitioning_chapter::plain_tree(bounds, things);
  std::size_t tests = 0;
  int touched = 0;
  for (int i = 0; i < 500; ++i) {
    CAPTURE(i);
    const Moving<Sphere> ball = flight(random);
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

TEST_CASE("The octree as one writes it first finds every coin that a ball comes to, and not many others") {
  std::mt19937 random(12);
  std::vector<Point> coins;
  for (int i = 0; i < 500; ++i)
    coins.push_back(5 * (1 + program::uniform(random)) * program::unit_vector(random));
  const Bounds cube(Point(-10, -10, -10), Point(10, 10, 10));
  const auto tree = partitioning_chapter::plain_octree(coins, cube, numbers_to(coins.size()), 20);
  std::size_t looks = 0;
  int reached = 0;
  for (int i = 0; i < 500; ++i) {
    CAPTURE(i);
    const Moving<Sphere> ball = flight(random);
    const auto found = partitioning_chapter::plain_search(tree, ball);
    looks += found.size();
    for (std::size_t k = 0; k < coins.size(); ++k) {
      const Vector to = coins[k] - ball.shape.center, &v = ball.displacement;
      const double t = std::clamp(to.dot(v) / v.squaredNorm(), 0.0, 1.0);
      if ((to - t * v).norm() > 0.199) continue;
      ++reached;
      REQUIRE(std::count(found.begin(), found.end(), k) == 1);
    }
  }
  CHECK(reached > 30);
  CHECK(looks < 500 * coins.size() / 20);
}

TEST_CASE("The octree as one writes it first loses a splinter that sticks out of its cube") {
  const std::vector<Triangle> splinters{{{-5, 0, 0}, {5, 0, 0}, {0, 0.1, 0}},
                                        {{2, 2, 2}, {2, 2, 2.1}, {2, 2.1, 2}}};
  const Moving<Sphere> ball{{{4, 0, 1}, 0.5}, {0, 0, -1}};
  CHECK(partitioning_chapter::plain_search(partitioning_chapter::plain_octree_of(splinters), ball).empty());
  CHECK(sweep(ball, Soup<Octree>(splinters))->time == Approx(0.5));
}

TEST_CASE("The BSP tree as one writes it first finds all that a ball touches") {
  std::mt19937 random(13);
  const auto walls = splinters(200, random);
  const auto tree = partitioning_chapter::plain_bsp(walls, numbers_to(walls.size()));
  int touched = 0, rejected = 0;
  for (int i = 0; i < 500; ++i) {
    CAPTURE(i);
    const Moving<Sphere> ball = flight(random);
    const auto found = partitioning_chapter::plain_search(tree, ball);
    for (std::size_t k = 0; k < walls.size(); ++k) {
      const bool is_found = std::count(found.begin(), found.end(), k) > 0;
      rejected += !is_found;
      if (!sweep(ball, walls[k])) continue;
      ++touched;
      REQUIRE(is_found);
    }
  }
  CHECK(touched > 50);
  CHECK(rejected > 10000);
}

TEST_CASE(
    "The BSP tree as one writes it first becomes a list, where walls stand in a row, and keeps many twice") {
  std::vector<Triangle> row;
  for (int i = 0; i < 64; ++i) row.push_back({{0, 0, 0.5 * i}, {1, 0, 0.5 * i}, {0, 1, 0.5 * i}});
  CHECK(partitioning_chapter::plain_bsp_costs(row, {}).depth == 63);
  CHECK(BspTree(row).depth() <= 6);

  std::mt19937 random(14);
  const auto walls = splinters(500, random);
  std::vector<Moving<Sphere>> balls;
  for (int i = 0; i < 100; ++i) balls.push_back(flight(random));
  const auto plain = partitioning_chapter::plain_bsp_costs(walls, balls);
  const Soup<BspTree> soup(walls);
  Statistics counted;
  std::size_t tests = 0;
  for (const Moving<Sphere>& ball : balls) {
    sweep(ball, soup, &counted);
    tests += counted.tests;
  }
  CHECK(plain.kept > 3 * walls.size() / 2);
  CHECK(plain.kept > soup.tree().order().size());
  CHECK(plain.found > 2 * tests);
}
