#pragma once
#include <cmath>
#include <vector>

// The order matters: Catch2 before RapidCheck.
#include "catch.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/octree.hpp"
//
#include <rapidcheck.h>
#include <rapidcheck/catch.h>

/// Small worlds for trees: how objects lie that trouble them, and what flies through.
namespace worlds {

using namespace first_contact;

/// A number in [-1, 1], with few digits, so that ties, shared edges and exact touching occur, or with many.
inline double number() {
  const int coarse = *rc::gen::inRange(-4, 5), fine = *rc::gen::inRange(-1000000, 1000001);
  return *rc::gen::arbitrary<bool>() ? coarse / 4.0 : fine / 1000003.0;
}

inline Vector vector() { return {number(), number(), number()}; }

/// How the objects of a scene lie.
enum class Arrangement { evenly, clustered, on_a_line, in_a_plane, in_one_point, all_the_same, far_away };

inline Point place(Arrangement arrangement) {
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
inline Triangle shard(Arrangement arrangement) {
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
inline World world() {
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
inline Moving<Sphere> ball_in(const World& world) {
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

inline Bounds box_in(const World& world) {
  const Point a = world.scale * vector(), b = world.scale * vector();
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

inline OctreeLimits octree_limits() {
  return {static_cast<std::size_t>(*rc::gen::inRange(0, 9)),
          static_cast<std::size_t>(*rc::gen::inRange(0, 21))};
}

inline BspLimits bsp_limits() {
  return {
      static_cast<std::size_t>(*rc::gen::inRange(0, 9)), static_cast<std::size_t>(*rc::gen::inRange(0, 70)),
      static_cast<std::size_t>(*rc::gen::inRange(0, 20)), static_cast<std::size_t>(*rc::gen::inRange(1, 9))};
}

}  // namespace worlds
