#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "first_contact/program/terrain.hpp"

// The floats of the fast tree may leave more to the doubles than they need, and its answers stay right: so what they leave
// is counted, in scenes each of which strains another of their bounds. A bound that is wider or narrower counts otherwise.
// Those of Intel and AMD estimate roots nearly alike, and differ by a few; others do it otherwise, or not at all.

using namespace first_contact;

namespace {

bool estimates_alike(const bvh::Walker& walker) {
  const std::string name = walker.name;
  return name.find("SSE") != name.npos || name.find("AVX") != name.npos;
}

Mesh hills(std::uint32_t n, double width, double roughness) {
  const Mesh square = program::height_field(n, 2, [=](double x, double y) {
    return roughness * (std::sin(9 * x) * std::cos(7 * y) + 0.2 * std::sin(50 * x + 31 * y));
  });
  std::vector<Point> vertices(square.vertices().begin(), square.vertices().end());
  for (Point& p : vertices) p.y() *= width;
  return {vertices, {square.faces().begin(), square.faces().end()}};
}

/// What flies: over which point, how large, from which height in radii, how steeply, how far.
struct Flight {
  double least_radius, most_radius, least_height, most_height, least_length, most_length;
  bool upwards = false;  // as often as down
  double far = 0;        // so much farther from where it starts to the surface
};

std::vector<Moving<Sphere>> flights(const Mesh& mesh, const Flight& kind, std::size_t count) {
  Chance chance(7);
  std::vector<Moving<Sphere>> all;
  while (all.size() < count) {
    const Triangle below = mesh.triangle(chance.pick(mesh.size()));
    const double u = chance.uniform(0, 1), v = chance.uniform(0, 1 - u);
    const Point over = below.a + u * (below.b - below.a) + v * (below.c - below.a);
    const double r = chance.log_uniform(kind.least_radius, kind.most_radius);
    const double height = r * chance.uniform(kind.least_height, kind.most_height);
    Vector way = chance.direction();
    if (!kind.upwards) way.z() = -std::abs(way.z());
    const double length = chance.log_uniform(kind.least_length, kind.most_length);
    const Point start = over + Vector(0, 0, height) - kind.far * way;
    all.push_back({Sphere{start, r}, (length + kind.far) * way});
  }
  return all;
}

/// Nodes, leaves, and leaves with triangles about which doubles decide.
using Work = std::array<double, 3>;

Work work_of(const Bvh& tree, const std::vector<Moving<Sphere>>& flights, const bvh::Walker& walker) {
  Work work{};
  for (const Moving<Sphere>& flight : flights) {
    bvh::SphereCast cast(flight, tree.parts(), walker);
    do {
      for (bvh::Pause at = cast.begin(); at != bvh::Pause::end;) {
        ++work[at == bvh::Pause::node ? 0 : at == bvh::Pause::leaf ? 1 : 2];
        at = at == bvh::Pause::node   ? cast.visit_node()
             : at == bvh::Pause::leaf ? cast.visit_leaf()
                                      : cast.decide();
      }
    } while (!cast.finish());
  }
  return work;
}

/// Triangles that are left, those of them whose face is touched for certain, and those that are only left.
Work certainty_of(const Bvh& tree, const std::vector<Moving<Sphere>>& flights, const bvh::Walker& walker) {
  Work count{};
  const bvh::Tree& nodes = tree.parts().tree;
  for (const auto& [sphere, displacement] : flights) {
    bvh::Walk walk;
    if (!find_path(nodes, {sphere.center.data(), displacement.data(), sphere.radius}, walk.path)) continue;
    start(nodes, walk.progress);
    while (walker.advance(nodes, walk) == bvh::Pause::survivors) {
      const bvh::Progress& at = walk.progress;
      count[0] += std::popcount(at.survivors);
      count[1] += std::popcount(at.survivors & at.touched);
      count[2] += std::popcount(at.survivors & at.untouched);
    }
  }
  return count;
}

struct Scene {
  std::string what;
  double width, roughness;
  Flight flight;
  Work expected, certain;
};

const std::vector<Scene> scenes{
    {"balls from above", 1, 0.1, {0.002, 0.1, 1.1, 3, 0.02, 1}, {6648, 3916, 1830}, {7960, 939, 145}},
    {"balls that overlap the surface",
     1,
     0.1,
     {0.002, 0.1, -0.9, 0.9, 0.02, 1, true},
     {8420, 7410, 5651},
     {18324, 941, 5305}},
    {"balls that only just overlap it",
     1,
     0.1,
     {0.01, 0.1, 0.99, 1.01, 1e-4, 0.01, true},
     {7449, 6399, 4071},
     {12292, 608, 4898}},
    {"large balls", 1, 0.1, {0.5, 5, 1, 1.2, 0.02, 1}, {53819, 159838, 25041}, {838420, 48, 5636}},
    {"points", 1, 0.1, {1e-30, 1e-29, 1e27, 1e28, 0.01, 0.5}, {5736, 1972, 953}, {974, 932, 0}},
    {"tiny balls", 1, 0.1, {1e-7, 1e-5, 1, 100, 1e-6, 1e-3, true}, {5482, 1591, 354}, {374, 243, 1}},
    {"triangles a hundred times as long as wide",
     0.01,
     0.003,
     {0.002, 0.05, -0.5, 2, 0.02, 0.3, true},
     {9245, 26958, 21080},
     {188097, 52, 2624}},
    {"triangles ten thousand times as long as wide",
     1e-4,
     1e-5,
     {2e-5, 1e-3, -0.5, 2, 1e-4, 0.1, true},
     {5901, 15001, 14458},
     {116523, 0, 0}},
    {"a floor that is nearly flat, and touched nearly everywhere",
     1,
     1e-7,
     {0.01, 0.1, 1, 1.00001, 0.01, 0.5, true},
     {7471, 7742, 2015},
     {12705, 0, 148}},
    {"a long way to it",
     1,
     0.1,
     {0.002, 0.1, 0, 2, 0.1, 1, false, 1e4},
     {8375, 6625, 3650},
     {17817, 1238, 0}},
    {"a way so long that floats hardly see the mesh",
     1,
     0.1,
     {0.002, 0.1, 0, 2, 0.1, 1, false, 1e7},
     {8474, 6760, 3732},
     {17983, 1232, 0}},
    {"balls that hardly move",
     1,
     0.1,
     {0.005, 0.05, -0.9, 0.99, 1e-9, 1e-6, true},
     {6432, 4063, 3362},
     {8589, 773, 2383}},
};

void compare(const Work& counted, const Work& expected, double part_in_doubt, const bvh::Walker& walker) {
  CAPTURE(walker.name, counted);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(counted[i] - expected[i]) <= 6 + part_in_doubt * expected[i]);
}

}  // namespace

TEST_CASE("The floats of the fast tree leave to the doubles what they left before, no more and no less") {
  for (const Scene& scene : scenes) {
    const Bvh tree(hills(60, scene.width, scene.roughness));
    const auto all = flights(tree.mesh(), scene.flight, 1500);
    for (const bvh::Walker* walker : bvh::all_walkers()) {
      CAPTURE(scene.what);
      compare(work_of(tree, all, *walker), scene.expected, estimates_alike(*walker) ? 0 : 0.25, *walker);
      if (estimates_alike(*walker)) compare(certainty_of(tree, all, *walker), scene.certain, 1e-4, *walker);
    }
  }
}
