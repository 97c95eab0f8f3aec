#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

// The order matters: Catch2 before RapidCheck.
#include "catch.hpp"
#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/objects.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/soup.hpp"
//
#include <rapidcheck.h>
#include <rapidcheck/catch.h>

using namespace first_contact;

namespace {

/// A number in [-1, 1], with few digits, so that ties, shared edges and exact touching occur, or with many.
double number() {
  const int coarse = *rc::gen::inRange(-4, 5), fine = *rc::gen::inRange(-1000000, 1000001);
  return *rc::gen::arbitrary<bool>() ? coarse / 4.0 : fine / 1000003.0;
}

Vector vector() { return {number(), number(), number()}; }

/// How the objects of a scene lie.
enum class Arrangement { evenly, clustered, on_a_line, in_a_plane, in_one_point, all_the_same, far_away };

Point place(Arrangement arrangement) {
  switch (arrangement) {
    case Arrangement::clustered:
      return vector() * std::exp2(-*rc::gen::inRange(0, 30));
    case Arrangement::on_a_line:
      return number() * Vector(1, 0.5, -0.25);
    case Arrangement::in_a_plane:
      return {number(), number(), 0};
    case Arrangement::in_one_point:
      return {0.25, -0.5, 0.125};
    case Arrangement::all_the_same:
      return {0.5, 0.25, 0};
    case Arrangement::far_away:
      return vector() + Vector(1e6, -1e6, 1e6);
    default:
      return vector();
  }
}

/// Large among small ones, and degenerate ones: segments and points.
Triangle shard(Arrangement arrangement) {
  const Point at = place(arrangement);
  if (arrangement == Arrangement::all_the_same) return {at, at + Vector(0.5, 0, 0), at + Vector(0, 0.5, 0)};
  const double size = std::exp2(-*rc::gen::inRange(0, 5));
  const Vector u = size * vector(), v = size * vector();
  const int kind = *rc::gen::inRange(0, 10);
  if (kind == 0) return {at, at, at};
  if (kind == 1) return {at, at + u, at + 2 * u};
  return {at, at + u, at + v};
}

struct World {
  std::vector<Triangle> shards;
  std::vector<Bounds> boxes;
  double scale = 1;
};

/// Of any arrangement, empty or not, at any scale.
World world() {
  World world;
  const auto arrangement = static_cast<Arrangement>(*rc::gen::inRange(0, 7));
  const auto count = *rc::gen::weightedOneOf<int>(
      {{1, rc::gen::just(0)}, {1, rc::gen::just(1)}, {8, rc::gen::inRange(2, 80)}});
  world.scale = *rc::gen::elementOf(std::vector<double>{1, 1, 1e-20, 1e20, 3});
  for (int i = 0; i < count; ++i) {
    const auto [a, b, c] = shard(arrangement);
    world.shards.emplace_back(world.scale * a, world.scale * b, world.scale * c);
    world.boxes.push_back(bounds_of(world.shards.back()));
  }
  return world;
}

/// A ball that flies through the world: any radius, or none; along an axis, at rest, or toward a corner.
Moving<Sphere> ball_in(const World& world) {
  const Point from = world.scale * 2 * vector();
  Vector motion = world.scale * 3 * vector();
  const int kind = *rc::gen::inRange(0, 6);
  if (kind == 0) motion.tail<2>().setZero();
  if (kind == 1) motion.setZero();
  if (kind >= 4 && !world.shards.empty())
    motion = world.shards[*rc::gen::inRange<std::size_t>(0, world.shards.size())].a - from;
  const double radius = *rc::gen::elementOf(std::vector<double>{0, 0.001, 0.125, 0.3, 1});
  return {{from, world.scale * radius}, motion};
}

Bounds box_in(const World& world) {
  const Point a = world.scale * vector(), b = world.scale * vector();
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

OctreeLimits octree_limits() {
  return {static_cast<std::size_t>(*rc::gen::inRange(0, 9)),
          static_cast<std::size_t>(*rc::gen::inRange(0, 21))};
}

BspLimits bsp_limits() {
  return {
      static_cast<std::size_t>(*rc::gen::inRange(0, 9)), static_cast<std::size_t>(*rc::gen::inRange(0, 70)),
      static_cast<std::size_t>(*rc::gen::inRange(0, 20)), static_cast<std::size_t>(*rc::gen::inRange(1, 9))};
}

/// The first contact by a loop that knows nothing of searches.
std::optional<Contact> first_by_loop(const Moving<Sphere>& ball, const std::vector<Triangle>& triangles) {
  std::optional<Contact> first;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    auto contact = sweep(ball, triangles[i]);
    if (!contact) continue;
    contact->triangle = i;
    const bool tie = first && contact->time == first->time;
    if (!first || contact->time < first->time || (tie && contact->feature < first->feature)) first = contact;
  }
  return first;
}

bool bitwise_equal(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->time == b->time && a->points == b->points && a->normal == b->normal && a->feature == b->feature &&
         a->triangle == b->triangle;
}

}  // namespace

TEST_CASE("Octree, BSP tree and brute force give the same first contact, to the last bit") {
  rc::prop("for any arrangement of triangles, at any scale", [] {
    const World w = world();
    const Soup<Octree> octree(w.shards, octree_limits());
    const Soup<BspTree> bsp(w.shards, bsp_limits());
    const Soup<BruteForce> all(w.shards);
    for (int i = 0; i < 8; ++i) {
      const auto ball = ball_in(w);
      const auto expected = first_by_loop(ball, w.shards);
      RC_CLASSIFY(expected.has_value(), "hit");
      RC_ASSERT(bitwise_equal(sweep(ball, octree), expected));
      RC_ASSERT(bitwise_equal(sweep(ball, bsp), expected));
      RC_ASSERT(bitwise_equal(sweep(ball, all), expected));
    }
  });
}

TEST_CASE("Octree, BSP tree and brute force find the same triangles on the way of a ball") {
  rc::prop("for any arrangement of triangles, at any scale", [] {
    const World w = world();
    const Soup<Octree> octree(w.shards, octree_limits());
    const Soup<BspTree> bsp(w.shards, bsp_limits());
    for (int i = 0; i < 4; ++i) {
      const auto ball = ball_in(w);
      std::vector<std::size_t> expected;
      for (std::size_t k = 0; k < w.shards.size(); ++k)
        if (sweep(ball, w.shards[k])) expected.push_back(k);
      RC_ASSERT(near(ball, octree) == expected);
      RC_ASSERT(near(ball, bsp) == expected);
    }
  });
}

TEST_CASE("Octree, BSP tree and brute force find the same triangles in a box") {
  rc::prop("for any arrangement of triangles, at any scale", [] {
    const World w = world();
    const Soup<Octree> octree(w.shards, octree_limits());
    const Soup<BspTree> bsp(w.shards, bsp_limits());
    for (int i = 0; i < 4; ++i) {
      const Bounds box = box_in(w);
      std::vector<std::size_t> expected;
      for (std::size_t k = 0; k < w.shards.size(); ++k)
        if (overlap(w.shards[k], box)) expected.push_back(k);
      RC_ASSERT(near(box, octree) == expected);
      RC_ASSERT(near(box, bsp) == expected);
    }
  });
}

TEST_CASE("An octree finds the objects near a box, and all pairs, that two loops find") {
  rc::prop("for any arrangement of objects, at any scale", [] {
    const World w = world();
    const Objects<Octree> octree(w.boxes, octree_limits());
    const Bounds box = box_in(w);
    std::vector<std::size_t> expected;
    std::vector<std::pair<std::size_t, std::size_t>> expected_pairs;
    for (std::size_t i = 0; i < w.boxes.size(); ++i) {
      if (overlap(w.boxes[i], box)) expected.push_back(i);
      for (std::size_t j = i + 1; j < w.boxes.size(); ++j)
        if (overlap(w.boxes[i], w.boxes[j])) expected_pairs.emplace_back(i, j);
    }
    RC_ASSERT(near(box, octree) == expected);
    RC_ASSERT(pairs(octree) == expected_pairs);
  });
}

TEST_CASE("An octree finds the objects on the way of a ball that brute force finds") {
  rc::prop("for any arrangement of objects, at any scale", [] {
    const World w = world();
    const Objects<Octree> octree(w.boxes, octree_limits());
    const Objects<BruteForce> all(w.boxes);
    const auto ball = ball_in(w);
    const auto found = near(ball, octree);
    RC_ASSERT(found == near(ball, all));
    for (std::size_t i = 0; i < w.shards.size(); ++i)  // and none that it touches is missing
      if (sweep(ball, w.shards[i])) RC_ASSERT(std::binary_search(found.begin(), found.end(), i));
  });
}

TEST_CASE("A scene that is larger by a power of two has the same contact, larger by it") {
  rc::prop("for every structure", [] {
    const World w = world();
    RC_PRE(w.scale == 1 || w.scale == 3);
    const double s = *rc::gen::elementOf(std::vector<double>{0x1p-30, 0.5, 0x1p20, 0x1p40});
    std::vector<Triangle> larger;
    for (const auto& [a, b, c] : w.shards) larger.emplace_back(s * a, s * b, s * c);
    const auto ball = ball_in(w);
    const Moving<Sphere> larger_ball{{s * ball.shape.center, s * ball.shape.radius}, s * ball.displacement};
    Statistics before, after;
    auto expected = sweep(ball, Soup<BspTree>(w.shards), &before);
    if (expected) expected->points *= s;
    RC_ASSERT(bitwise_equal(sweep(larger_ball, Soup<BspTree>(larger), &after), expected));
    RC_ASSERT(before == after);
    RC_ASSERT(bitwise_equal(sweep(larger_ball, Soup<Octree>(larger)), expected));
  });
}

TEST_CASE("Where a ball touches a triangle it is there, within a quarter of the search margin") {
  rc::prop("so no node that holds a hit is passed over", [] {
    const World w = world();
    RC_PRE(!w.shards.empty());
    const auto ball = ball_in(w);
    Bounds scene = bounds_of(w.boxes);
    const double largest = std::max({largest_coordinate(scene), ball.shape.center.cwiseAbs().maxCoeff(),
                                     ball.displacement.cwiseAbs().maxCoeff(), ball.shape.radius});
    for (const Triangle& triangle : w.shards) {
      const auto contact = sweep(ball, triangle);
      if (!contact) continue;
      const Point center = ball.shape.center + contact->time * ball.displacement;
      const double distance = (center - closest_point(center, triangle)).norm();
      RC_ASSERT(distance <= ball.shape.radius + search_margin / 4 * largest);
    }
  });
}

TEST_CASE("Each node of an octree has eight children or none, and each object is in one leaf") {
  rc::prop("for any arrangement and any limits", [] {
    const World w = world();
    const OctreeLimits limits = octree_limits();
    const Octree tree(std::span<const Bounds>(w.boxes), limits);
    std::vector<int> seen(w.boxes.size(), 0);
    for (std::size_t i = 0; i < tree.nodes(); ++i) {
      const Octree::Node& node = tree.node(i);
      for (std::uint32_t k = node.begin; k < node.end; ++k) {
        const Bounds& object = w.boxes[tree.order()[k]];
        RC_ASSERT((node.bounds.min().array() <= object.min().array()).all());
        RC_ASSERT((node.bounds.max().array() >= object.max().array()).all());
        if (node.is_leaf()) ++seen[tree.order()[k]];
      }
      if (!node.is_leaf()) RC_ASSERT(node.first_child + 8 <= tree.nodes());
    }
    RC_ASSERT((tree.nodes() - 1) % 8 == 0U);
    RC_ASSERT(tree.depth() <= limits.depth);
    RC_ASSERT(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
  });
}

TEST_CASE("Each node of a BSP tree has two children or none, and its polygons lie where they are kept") {
  rc::prop("for any arrangement and any limits", [] {
    const World w = world();
    const BspLimits limits = bsp_limits();
    const BspTree tree(w.shards, limits);
    std::vector<int> seen(w.shards.size(), 0);
    const double thickness = BspTree::thickness * largest_coordinate(bounds_of(w.boxes));
    for (std::size_t i = 0; i < tree.nodes(); ++i) {
      const BspTree::Node& node = tree.node(i);
      for (std::uint32_t k = node.begin; k < node.end; ++k) {
        ++seen[tree.order()[k]];
        const Triangle& triangle = w.shards[tree.order()[k]];
        if (!node.is_leaf() && tree.order().size() == w.shards.size())  // none was cut
          for (const Point& corner : {triangle.a, triangle.b, triangle.c})
            RC_ASSERT(std::abs(node.plane->signed_distance(corner)) <= thickness);
      }
      if (!node.is_leaf()) RC_ASSERT(std::max(node.front, node.back) < tree.nodes());
    }
    RC_ASSERT(tree.nodes() % 2 == 1U);
    RC_ASSERT(tree.depth() <= std::min<std::size_t>(limits.depth, 64));
    RC_ASSERT(tree.order().size() <= std::max<std::size_t>(limits.growth * w.shards.size(), 1));
    RC_ASSERT(std::all_of(seen.begin(), seen.end(), [](int n) { return n >= 1; }));
  });
}

TEST_CASE("A tree of boxes gives the first contact and the triangles of brute force, to the last bit") {
  rc::prop("for any arrangement of triangles, at any scale", [] {
    const World w = world();
    const Soup<BoxTree> boxes(w.shards, BoxTreeLimits{static_cast<std::size_t>(*rc::gen::inRange(0, 9))});
    const Soup<BruteForce> all(w.shards);
    for (int i = 0; i < 8; ++i) {
      const auto ball = ball_in(w);
      RC_ASSERT(bitwise_equal(sweep(ball, boxes), first_by_loop(ball, w.shards)));
      RC_ASSERT(near(ball, boxes) == near(ball, all));
      const Bounds box = box_in(w);
      RC_ASSERT(near(box, boxes) == near(box, all));
    }
  });
}

TEST_CASE("Every box of a tree of boxes holds its two children, and every object is in one leaf") {
  rc::prop("for any arrangement of boxes", [] {
    const World w = world();
    const std::size_t capacity = static_cast<std::size_t>(*rc::gen::inRange(1, 9));
    const BoxTree tree(std::span<const Bounds>(w.boxes), BoxTreeLimits{capacity});
    std::vector<std::size_t> times_seen(w.boxes.size());
    for (std::size_t i = 0; i < tree.nodes(); ++i) {
      const BoxTree::Node& node = tree.node(i);
      Bounds around = node.bounds;
      for (std::uint32_t k = node.begin; k < node.end; ++k) around.extend(w.boxes[tree.order()[k]]);
      RC_ASSERT(around.min() == node.bounds.min() && around.max() == node.bounds.max());
      if (!node.is_leaf()) continue;
      RC_ASSERT(node.end - node.begin <= capacity);
      for (std::uint32_t k = node.begin; k < node.end; ++k) ++times_seen[tree.order()[k]];
    }
    for (const std::size_t times : times_seen) RC_ASSERT(times == 1U);
  });
}

TEST_CASE(
    "To build a tree no object is looked at more often than once a level for each question asked of it") {
  rc::prop("for any arrangement of triangles", [] {
    const World w = world();
    const std::size_t k = w.shards.size();
    const Octree octree(w.shards, octree_limits());
    const BoxTree boxes(std::span<const Triangle>(w.shards));
    RC_ASSERT(octree.work() <= k * octree.depth());    // in which eighth?
    RC_ASSERT(boxes.work() <= 4 * k * boxes.depth());  // in which bin, along three axes; and its box
    RC_ASSERT(BruteForce(w.shards).work() == 0U);
  });
}

TEST_CASE("A tree never tests more objects than there are, and counts as many hits as it finds") {
  rc::prop("for any arrangement of triangles", [] {
    const World w = world();
    const auto ball = ball_in(w);
    const Soup<Octree> octree(w.shards);
    const Soup<BspTree> bsp(w.shards);
    const Soup<BruteForce> all(w.shards);
    Statistics of_octree, of_bsp, of_all;
    const auto found = near(ball, octree, &of_octree);
    near(ball, bsp, &of_bsp);
    near(ball, all, &of_all);
    RC_ASSERT(of_all == (Statistics{1, 0, w.shards.size(), found.size()}));
    for (const Statistics& of_tree : {of_octree, of_bsp}) {
      RC_ASSERT(of_tree.tests <= w.shards.size());
      RC_ASSERT(of_tree.hits == found.size());
    }
    RC_ASSERT(of_octree.nodes <= octree.tree().nodes());
    RC_ASSERT(of_octree.depth <= octree.tree().depth());
  });
}
