#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/brute_force.hpp"
#include "first_contact/trees/objects.hpp"
#include "first_contact/trees/soup.hpp"
#include "property/worlds.hpp"

using namespace first_contact;
using namespace worlds;

namespace {

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
