#include "first_contact/bvh/bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "catch.hpp"
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "first_contact/geometry/environment.hpp"
#include "first_contact/program/terrain.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/trees/plain_bvh.hpp"
#include "property/same_contact.hpp"

using namespace first_contact;

namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
Vector vector(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

/// A grid of squares, flat or bumpy, with shared vertices.
Mesh grid(Random& random, bool flat, double size, const Vector& offset) {
  const std::uint32_t n = 2 + static_cast<std::uint32_t>(random() % 5);
  std::vector<Point> points;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double height = flat ? 0 : static_cast<double>(random() % 3) / 4;
      points.emplace_back(size * Point(2.0 * i / n - 1, 2.0 * j / n - 1, height) + offset);
    }
  return {std::move(points), program::grid_faces(n)};
}

/// A mesh of the kinds that trouble: loose triangles, slivers, duplicates, a grid whose vertices are on whole
/// numbers, a patch with T-junctions, degenerate triangles, a flat floor.
Mesh troublesome(Random& random, double size, const Vector& offset) {
  std::vector<Point> points;
  std::vector<Mesh::Face> faces;
  const auto add = [&](const Point& a, const Point& b, const Point& c) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point& p : {a, b, c}) points.emplace_back(size * p + offset);
    faces.push_back({first, first + 1, first + 2});
  };
  const auto kind = random() % 7;
  const std::size_t count = 1 + random() % 60;
  if (kind == 6 || kind == 4) return grid(random, kind == 6, size, offset);
  for (std::size_t i = 0; i < count; ++i) {
    const Point a = vector(random, 1), b = a + vector(random, 0.3), c = a + vector(random, 0.3);
    const auto whole = [&] { return Point(vector(random, 3).array().round() / 3); };
    switch (kind) {
      case 0:
        add(a, b, c);
        break;
      case 1:
        add(a, b, a + uniform(random, 0, 1) * (b - a) + vector(random, 1e-12));
        break;  // slivers
      case 2:
        add(a, b, c);
        add(b, c, a);
        add(c, b, a);
        break;  // duplicates
      case 3:
        add(whole(), whole(), whole());
        break;    // degenerate, crossing
      default: {  // T-junctions
        const Point m = a + uniform(random, 0, 1) * (b - a);
        add(a, b, c);
        add(a, m, a + b - c);
        add(m, b, a + b - c);
      }
    }
  }
  return {points, faces};
}

Moving<Sphere> cast(Random& random, const Mesh& mesh, double size) {
  const Triangle t = mesh.triangle(random() % mesh.size());
  const double r = random() % 8 ? size * std::exp(uniform(random, -5, 0)) : 0;
  const Point target = random() % 3 == 0 ? t.a : Point(t.a + uniform(random, 0, 1) * (t.b - t.a));
  Vector v = vector(random, size * std::exp(uniform(random, -3, 2)));
  if (random() % 4 == 0)
    v = size / 4 * Vector(vector(random, 2).array().round());  // along the axes, or at rest
  const double height = random() % 3 ? r * uniform(random, 0.5, 2) : r;
  const Vector away = random() % 2 ? Vector(0, 0, height) : vector(random, height);
  return {Sphere{target + away - uniform(random, 0, 1) * v, r}, v};
}

Mesh shuffled(const Mesh& mesh, Random& random, std::vector<std::uint32_t>& order) {
  order.resize(mesh.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<Mesh::Face> faces;
  for (const std::uint32_t i : order) faces.push_back(mesh.faces()[i]);
  return {mesh.vertices(), faces};
}

}  // namespace

TEST_CASE(
    "The tree, plain or fast, on any instruction set, answers what all triangles together answer, bit for "
    "bit") {
  const std::uint64_t seed = GENERATE(range(1u, 400u));
  Random random(seed);
  const double size = std::pow(10.0, static_cast<double>(random() % 13) - 6);
  const Mesh mesh =
      troublesome(random, size, random() % 3 ? Vector(Vector::Zero()) : vector(random, 1000 * size));
  const Environment environment(mesh);
  const PlainBvh plain(mesh);
  const Bvh fast(mesh);
  const auto walkers = bvh::all_walkers();
  std::vector<Moving<Sphere>> casts;
  std::vector<std::optional<Contact>> expected;
  for (int i = 0; i < 100; ++i) {
    casts.push_back(cast(random, mesh, size));
    expected.push_back(sweep(casts.back(), environment));
    CAPTURE(seed, i, told(expected.back()), told(sweep(casts.back(), plain)),
            told(sweep(casts.back(), fast)));
    REQUIRE(same(sweep(casts.back(), plain), expected.back()));
    REQUIRE(same(sweep(casts.back(), fast), expected.back()));
    for (const bvh::Walker* walker : walkers)
      REQUIRE(same(bvh::sweep(casts.back(), fast.parts(), *walker), expected.back()));
  }
  std::vector<std::optional<Contact>> found(casts.size());
  sweep(casts, fast, found);
  for (std::size_t i = 0; i < casts.size(); ++i) REQUIRE(same(found[i], expected[i]));
}

TEST_CASE("A scene scaled by a power of two gives the scaled answer of the tree, bit for bit") {
  const std::uint64_t seed = GENERATE(range(1u, 60u));
  const double scale = GENERATE(0x1p-40, 0x1p-3, 0x1p20);
  Random random(seed);
  const Mesh mesh = troublesome(random, 1, vector(random, 5));
  std::vector<Point> points;
  for (const Point& p : mesh.vertices()) points.emplace_back(scale * p);
  const Bvh tree(mesh), scaled_tree(Mesh(points, mesh.faces()));
  for (int i = 0; i < 50; ++i) {
    const Moving<Sphere> moving = cast(random, mesh, 1);
    const Moving<Sphere> scaled{Sphere{scale * moving.shape.center, scale * moving.shape.radius},
                                scale * moving.displacement};
    auto expected = sweep(moving, tree);
    if (expected) expected->points *= scale;
    CAPTURE(seed, scale, i);
    REQUIRE(same(sweep(scaled, scaled_tree), expected));
  }
}

TEST_CASE(
    "The answer does not depend on the order of the triangles, and of several touched ones it is the first") {
  const std::uint64_t seed = GENERATE(range(1u, 100u));
  Random random(seed);
  const Mesh mesh = troublesome(random, 1, Vector::Zero());
  std::vector<std::uint32_t> order;
  const Bvh tree(mesh), other(shuffled(mesh, random, order));
  for (int i = 0; i < 50; ++i) {
    const Moving<Sphere> moving = cast(random, mesh, 1);
    const auto a = sweep(moving, tree);
    auto b = sweep(moving, other);
    if (a && b) b->triangle = a->triangle;
    CAPTURE(seed, i, told(a), told(b));
    REQUIRE(same(a, b));
  }
}

namespace {

/// Two triangles at a common edge, the second bent by a part of their size; and a radius of their kind.
struct Ridge {
  Ridge(Random& random, double bend)
      : size(std::pow(10.0, uniform(random, -6, 6))),
        r(size * std::exp(uniform(random, -4, 2))),
        a(vector(random, size)),
        ab(vector(random, size)),
        ac(vector(random, size)),
        mesh({a, a + ab, a + ac, Point(a + ab + ac + vector(random, bend * size))}, {{0, 1, 2}, {1, 3, 2}}),
        normal(mesh.triangle(0).area_vector().normalized()) {}

  double size, r;
  Point a;
  Vector ab, ac;
  Mesh mesh;
  Vector normal;
};

void require_alike(const Mesh& mesh, const Moving<Sphere>& moving) {
  const Bvh fast(mesh);
  const auto expected = sweep(moving, Environment(mesh));
  CAPTURE(told(expected), told(sweep(moving, fast)));
  REQUIRE(same(sweep(moving, PlainBvh(mesh)), expected));
  REQUIRE(same(sweep(moving, fast), expected));
  static const auto walkers = bvh::all_walkers();
  for (const bvh::Walker* walker : walkers) {
    CAPTURE(walker->name);
    REQUIRE(same(bvh::sweep(moving, fast.parts(), *walker), expected));
  }
}

}  // namespace

TEST_CASE("A sphere that slides within rounding of a face is answered alike by all") {
  const std::uint64_t seed = GENERATE(range(1u, 300u));
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const Ridge on(random, 0);
    const Vector along = on.normal.cross(vector(random, on.size));
    const Point lowest = on.a + uniform(random, -1, 2) * on.ab + uniform(random, -1, 2) * on.ac;
    const Vector tilt = std::pow(10.0, uniform(random, -17, -12)) * along.norm() * on.normal;
    CAPTURE(seed, i);
    require_alike(on.mesh,
                  {Sphere{lowest + on.r * on.normal, on.r}, random() % 2 ? Vector(along - tilt) : along});
  }
}

TEST_CASE("A sphere deep in a face, or hardly off it, that goes deeper or leaves, is answered alike by all") {
  const std::uint64_t seed = GENERATE(range(1u, 300u));
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const Ridge on(random, 0.3);
    const Point below = on.a + uniform(random, 0, 0.5) * on.ab + uniform(random, 0, 0.5) * on.ac;
    const double height = on.r * std::pow(10.0, uniform(random, -18, 0.3)) * (random() % 2 ? 1 : -1);
    const Vector across = vector(random, on.size * std::pow(10.0, uniform(random, -3, 0)));
    const Vector v = random() % 2 ? Vector(uniform(random, -1, 1) * on.size * on.normal) : across;
    CAPTURE(seed, i);
    require_alike(on.mesh, {Sphere{below + height * on.normal, on.r}, v});
  }
}

TEST_CASE("A tree of nothing is touched by nothing") {
  const Bvh fast(Mesh({}, {}));
  CHECK_FALSE(sweep(Moving<Sphere>{{{0, 0, 0}, 1}, {1, 0, 0}}, fast));
  CHECK_FALSE(sweep(Moving<Sphere>{{{0, 0, 0}, 1}, {1, 0, 0}}, PlainBvh(Mesh({}, {}))));
  sweep(std::span<const Moving<Sphere>>{}, fast, {});
}

TEST_CASE("The walk is compiled for the plainest of machines, and for the machine that runs this") {
  const auto walkers = bvh::all_walkers();
  CHECK(walkers.size() >= 1);
  CHECK(std::find(walkers.begin(), walkers.end(), &bvh::best_walker()) != walkers.end());
}
