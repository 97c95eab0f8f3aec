#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/bvh/kernels/walker.hpp"
#include "first_contact/geometry/products.hpp"

// Which features of a triangle may a sphere touch, and when? The doubles of the fast tree answer with margins: what is kept
// for one that is too narrow is missed, and one that is too wide costs time. So triangles are touched at known places and
// times, near all borders between one feature and the next; what is kept is counted, and so is how well the times are known.

using namespace first_contact;

namespace {

/// A sphere that touches a triangle at a known place and time.
struct Meeting {
  std::array<Point, 3> corner;
  Point center;
  Vector travel;
  double radius, time;
};

/// Of two random numbers one is small as often as not: how small, is as random.
double hardly(Chance& chance) {
  return chance.pick(2) ? chance.log_uniform(0x1p-40, 1) : chance.uniform(0, 1);
}

std::array<Point, 3> triangle(Chance& chance) {
  const Vector u = chance.direction(), v = u.cross(chance.direction()).normalized();
  const Point a = chance.vector(1);
  const double along = chance.uniform(0, 1), height = chance.log_uniform(1e-6, 1);
  return {a, a + u, a + along * u + height * v};
}

/// A point of the triangle, and a way from it to which no other point of the triangle is nearer.
std::pair<Point, Vector> place(const std::array<Point, 3>& corner, Chance& chance) {
  const std::size_t i = chance.pick(3);
  const Point &a = corner[i], &b = corner[(i + 1) % 3], &c = corner[(i + 2) % 3];
  const Vector normal = (b - a).cross(c - a).normalized() * (chance.pick(2) ? 1 : -1);
  const Vector along = (b - a).normalized(), side = (c - a).normalized();
  const Vector outward = (dot(c - a, along) * along - (c - a)).normalized();  // from the edge ab
  const double near_a = hardly(chance), turn = hardly(chance) * std::numbers::pi / 2;
  const std::size_t kind = chance.pick(3);
  if (kind == 0) {
    const double to_c = hardly(chance) * (1 - near_a);
    return {a + near_a * (b - a) + to_c * (c - a), normal};
  }
  if (kind == 1) return {a + near_a * (b - a), Vector(std::cos(turn) * normal + std::sin(turn) * outward)};
  // Of the ways that lead from both edges at a: at right angles to ab, but for a little, and turned out.
  Vector way = std::cos(turn) * normal + std::sin(turn) * outward - hardly(chance) * along;
  if (const double to_c = dot(way, side); to_c > 0) way -= to_c * side;
  if (const double to_b = dot(way, along); to_b > 0) way -= to_b * along;
  return {a, way.normalized()};
}

Meeting meeting(Chance& chance) {
  const std::array<Point, 3> corner = triangle(chance);
  const auto [touched, way] = place(corner, chance);
  const double small = chance.log_uniform(0x1p-12, 4), large = chance.log_uniform(4, 0x1p20);
  const double radius = std::array{small, 0.0, large}[chance.pick(4) % 3];
  const double length = chance.log_uniform(0x1p-6, 4);
  Vector travel = length * chance.direction();
  if (dot(travel, way) > 0) travel = -travel;
  const double time = chance.uniform(0.1, 0.9);
  return {corner, Point(touched + radius * way - time * travel), travel, radius, time};
}

bvh::Found found(const Meeting& m, double latest, bool overlapping, const bvh::Walker& walker) {
  const bvh::Question question{m.center.data(), m.travel.data(), m.radius};
  return walker.features_in_time(question, m.corner[0].data(), m.corner[1].data(), m.corner[2].data(), latest,
                                 overlapping);
}

/// The earliest time of the features that are kept; 2 if there is none.
double earliest(const bvh::Found& found) {
  double early = 2;
  for (unsigned left = found.features; left != 0; left &= left - 1)
    early = std::min(early, found.early[std::countr_zero(left)]);
  return early;
}

/// What is kept of many triangles: faces, edges, vertices; faces that are touched within their sides for certain; triangles
/// whose time is known from both sides, and, summed up, by how many bits; and the bits of the times that nothing comes before.
struct Kept {
  double faces = 0, edges = 0, vertices = 0, within = 0, bounded = 0, bits = 0, early_bits = 0;

  void add(const bvh::Found& found, double time) {
    faces += found.features & 1;
    edges += std::popcount(found.features >> 1 & 7);
    vertices += std::popcount(found.features >> 4);
    within += found.within;
    const double early = earliest(found);
    if (early > 0 && early < time) early_bits -= std::log2(time - early);
    if (!(found.late <= 1)) return;
    ++bounded;
    if (early > 0) bits -= std::log2(found.late - early);
  }
};

void compare(double counted, double expected, const std::string& of, const bvh::Walker& walker) {
  CAPTURE(of, walker.name, counted);
  CHECK(std::abs(counted - expected) <= 2 + expected / 20000);
}

void compare(const Kept& kept, const Kept& expected, const bvh::Walker& walker) {
  compare(kept.faces, expected.faces, "faces", walker);
  compare(kept.edges, expected.edges, "edges", walker);
  compare(kept.vertices, expected.vertices, "vertices", walker);
  compare(kept.within, expected.within, "within", walker);
  compare(kept.bounded, expected.bounded, "bounded", walker);
  compare(kept.bits, expected.bits, "bits", walker);
  compare(kept.early_bits, expected.early_bits, "early bits", walker);
}

}  // namespace

TEST_CASE("What is touched first of a triangle is kept, and nothing is said to come later than it does") {
  for (const bvh::Walker* walker : bvh::all_walkers()) {
    Chance chance(1);
    for (int i = 0; i < 20000; ++i) {
      const Meeting m = meeting(chance);
      const bvh::Found kept = found(m, 1, false, *walker);
      CAPTURE(walker->name, i, m.time, kept.features, kept.late);
      REQUIRE(earliest(kept) <= m.time);
      REQUIRE(kept.late >= m.time - 0x1p-40);
    }
  }
}

TEST_CASE("Of features that are touched on the way no more are kept than were, and their times are as sure") {
  for (const bvh::Walker* walker : bvh::all_walkers()) {
    Chance chance(2);
    Kept kept;
    for (int i = 0; i < 20000; ++i) {
      const Meeting m = meeting(chance);
      kept.add(found(m, 1, false, *walker), m.time);
    }
    compare(kept, {15329, 28750, 14647, 703, 16999, 175740, 199193}, *walker);
  }
}

TEST_CASE("Of features that are touched late, or just too late, no more are kept than were") {
  for (const bvh::Walker* walker : bvh::all_walkers()) {
    Chance chance(3);
    Kept kept;
    for (int i = 0; i < 20000; ++i) {
      const Meeting m = meeting(chance);
      const double off = chance.log_uniform(0x1p-52, 0x1p-4);
      kept.add(found(m, m.time + (chance.pick(2) ? off : -off), false, *walker), m.time);
    }
    compare(kept, {12589, 16626, 8275, 498, 11465, 118533, 159739}, *walker);
  }
}

TEST_CASE("Of features of a triangle that is overlapped at the start no more are kept than were") {
  for (const bvh::Walker* walker : bvh::all_walkers()) {
    Chance chance(4);
    Kept kept;
    for (int i = 0; i < 20000; ++i) {
      Meeting m = meeting(chance);
      // At its place at the touch, and in by a little, or by much.
      m.center += m.time * m.travel;
      const Point from = m.corner[chance.pick(3)];
      m.center -= hardly(chance) * m.radius * (m.center - from).normalized();
      if (chance.pick(3) == 0) m.travel = -m.travel;
      kept.add(found(m, 1, true, *walker), m.time);
    }
    compare(kept, {12252, 19356, 6941, 265, 370, 0, 0}, *walker);
  }
}
