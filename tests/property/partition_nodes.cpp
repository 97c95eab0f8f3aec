#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/objects.hpp"
#include "first_contact/trees/soup.hpp"
#include "property/worlds.hpp"

using namespace first_contact;
using namespace worlds;

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
