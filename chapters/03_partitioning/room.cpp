#include "room.hpp"

#include <cmath>

#include "first_contact/program/random.hpp"

using namespace first_contact;
using program::Random;

namespace {

// By Newton's method: the library's own function may differ in its last bit from platform to platform.
double cube_root(double value) {
  double root = value;
  for (int i = 0; i < 64; ++i) root = (2 * root + value / (root * root)) / 3;
  return root;
}

struct Place {
  Point at;
  double scale;
};

// The clusters' middle is off every plane along which an octree divides the room.
Place place(Spread spread, Random& random) {
  if (spread == Spread::even) return {random.vector(), 1};
  const double scale = std::ldexp(1.0, -random.below(12));
  return {Point(0.3, 0.6, 0.45) + scale * 0.6 * (random.vector() - Vector::Constant(0.5)), scale};
}

}  // namespace

std::vector<Triangle> shards(std::size_t count, Spread spread, std::uint64_t seed) {
  Random random(seed);
  const double size = count > 0 ? 0.5 / cube_root(static_cast<double>(count)) : 0;
  std::vector<Triangle> all;
  all.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Place middle = place(spread, random);
    const auto corner = [&] {
      return Point(middle.at + size * middle.scale * (2 * random.vector() - Vector::Ones()));
    };
    const Point a = corner(), b = corner(), c = corner();
    all.emplace_back(a, b, c);
  }
  return all;
}

std::vector<Bounds> points(std::size_t count, Spread spread, std::uint64_t seed) {
  Random random(seed);
  std::vector<Bounds> all;
  all.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point at = place(spread, random).at;
    all.emplace_back(at, at);
  }
  return all;
}

std::vector<Moving<Sphere>> flights(std::size_t count, const Bounds& room, std::uint64_t seed) {
  Random random(seed);
  const Bounds box = room.isEmpty() ? bounds_between({0, 0, 0}, {1, 1, 1}) : room;
  const Vector size = box.sizes();
  std::vector<Moving<Sphere>> all;
  all.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point from = box.min() + size.cwiseProduct(random.vector());
    const Point to = box.min() + size.cwiseProduct(random.vector());
    all.push_back({{from, 0.01 * size.maxCoeff()}, to - from});
  }
  return all;
}

std::vector<Moving<Sphere>> flights_at(const std::vector<Triangle>& triangles, std::size_t count,
                                       const Bounds& room, std::uint64_t seed) {
  auto all = flights(count, room, seed);
  Random random(seed + 1);
  for (auto& ball : all) {
    const auto target = static_cast<std::size_t>(random.below(static_cast<int>(triangles.size())));
    ball.displacement = triangles[target].a - ball.shape.center;
  }
  return all;
}
