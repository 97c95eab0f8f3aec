#include <cmath>
#include <vector>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "first_contact/program/terrain.hpp"
#include "first_contact/trees/box_tree.hpp"
#include "first_contact/trees/bsp_tree.hpp"
#include "first_contact/trees/octree.hpp"
#include "first_contact/trees/soup.hpp"

// How much a tree has to look at is counted, not timed: one that is cut or searched worse looks at more. The
// limits are what a flight took on the average when they were set, and a fiftieth more.

using namespace first_contact;

namespace {

/// Hills on a square from -1 to 1, of 2 n^2 triangles.
Mesh hills(std::uint32_t n) {
  return program::height_field(n, 2, [](double x, double y) {
    return 0.1 * std::sin(9 * x) * std::cos(7 * y) + 0.02 * std::sin(50 * x + 31 * y);
  });
}

/// Balls of many sizes that fly far and near over a surface, and into it as often as not.
std::vector<Moving<Sphere>> flights(const Mesh& mesh, std::size_t count) {
  Chance chance(1);
  std::vector<Moving<Sphere>> all;
  while (all.size() < count) {
    const Triangle below = mesh.triangle(chance.pick(mesh.size()));
    const double r = chance.log_uniform(0.002, 0.1), length = chance.log_uniform(0.02, 1);
    const Point start = below.a + Vector(0, 0, 1.2 * r + chance.uniform(0, 0.05));
    Vector way = chance.direction();
    way.z() = -std::abs(way.z());
    all.push_back({Sphere{start, r}, length * way});
  }
  return all;
}

struct Work {
  double nodes = 0, leaves = 0, decisions = 0;  // leaves with triangles that doubles decide about
};

/// What the fast tree looks at, per flight.
Work work_of(const Bvh& tree, const std::vector<Moving<Sphere>>& flights) {
  Work work;
  for (const Moving<Sphere>& flight : flights) {
    bvh::SphereCast cast(flight, tree.parts(), tree.parts().walker);
    do {
      for (bvh::Pause at = cast.begin(); at != bvh::Pause::end;) {
        if (at == bvh::Pause::node) ++work.nodes;
        if (at == bvh::Pause::leaf) ++work.leaves;
        if (at == bvh::Pause::survivors) ++work.decisions;
        at = at == bvh::Pause::node   ? cast.visit_node()
             : at == bvh::Pause::leaf ? cast.visit_leaf()
                                      : cast.decide();
      }
    } while (!cast.finish());
  }
  const auto n = static_cast<double>(flights.size());
  return {work.nodes / n, work.leaves / n, work.decisions / n};
}

/// What a plain tree looks at, per flight: nodes and triangles.
template <class Tree>
std::pair<double, double> work_of(const Soup<Tree>& soup, const std::vector<Moving<Sphere>>& flights) {
  double nodes = 0, tests = 0;
  for (const Moving<Sphere>& flight : flights) {
    Statistics counted;
    sweep(flight, soup, &counted);
    nodes += static_cast<double>(counted.nodes);
    tests += static_cast<double>(counted.tests);
  }
  const auto n = static_cast<double>(flights.size());
  return {nodes / n, tests / n};
}

void at_most(double counted, double limit) {
  CHECK(counted <= 1.02 * limit);
  CHECK(counted >= 0.5 * limit);  // or the limit says nothing
}

}  // namespace

TEST_CASE("The fast tree looks at no more nodes, leaves and survivors than its limit") {
  const Bvh tree(hills(100));
  const Work work = work_of(tree, flights(tree.mesh(), 2000));
  CAPTURE(work.nodes, work.leaves, work.decisions);
  at_most(work.nodes, 6.09);
  at_most(work.leaves, 4.06);
  at_most(work.decisions, 1.52);
}

TEST_CASE("The fast tree takes no more memory than its limit") {
  const Mesh mesh = hills(100);
  at_most(static_cast<double>(Bvh(mesh).bytes()) / static_cast<double>(mesh.size()), 41.7);
}

TEMPLATE_TEST_CASE("A plain tree looks at no more nodes and triangles than its limit", "", Octree, BspTree,
                   BoxTree) {
  const Mesh mesh = hills(20);
  const Soup<TestType> soup(mesh);
  const auto [nodes, tests] = work_of(soup, flights(mesh, 500));
  CAPTURE(nodes, tests);
  if constexpr (std::is_same_v<TestType, Octree>) {
    at_most(nodes, 39.73);
    at_most(tests, 10.37);
  } else if constexpr (std::is_same_v<TestType, BspTree>) {
    at_most(nodes, 26.18);
    at_most(tests, 17.25);
  } else {
    at_most(nodes, 22.49);
    at_most(tests, 9.2);
  }
}
