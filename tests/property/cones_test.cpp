#include "first_contact/partition/bvh/cones.hpp"

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "catch.hpp"
#include "first_contact/partition/bvh.hpp"
#include "first_contact/partition/bvh/parts.hpp"
#include "first_contact/partition/plain_bvh.hpp"
#include "property/same_contact.hpp"

using namespace first_contact;

namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
double log_uniform(Random& random, double low, double high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}
Vector direction(Random& random) {
  std::normal_distribution<double> normal;
  return Vector(normal(random), normal(random), normal(random)).normalized();
}

/// A grid of n n squares, two triangles each, from -1 to 1, with the heights of `height(x, y)`.
template <class Height>
Mesh grid(std::uint32_t n, const Height& height) {
  std::vector<Point> points;
  std::vector<Mesh::Face> faces;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
      points.emplace_back(x, y, height(x, y));
    }
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, c = a + n + 1;
      faces.push_back({a, a + 1, c + 1});
      faces.push_back({a, c + 1, c});
    }
  return {std::move(points), std::move(faces)};
}

/// Hills, some gentle, some rough, some with a crease; some triangles turned over, missing or there twice.
Mesh hills(Random& random) {
  const auto n = 3 + static_cast<std::uint32_t>(random() % 25);
  const double wave = uniform(random, 0.5, 6), size = log_uniform(random, 1e-3, 3) / wave,
               noise = log_uniform(random, 1e-6, 1) / n;
  const bool creased = random() % 2;
  const Mesh smooth = grid(n, [&](double x, double y) {
    const double hill = std::sin(wave * x) * (creased ? 1 : std::cos(wave * y));
    return size * (creased ? std::abs(hill) : hill) + noise * uniform(random, -1, 1);
  });
  std::vector<Mesh::Face> faces;
  const bool spoilt = random() % 2;
  for (Mesh::Face face : smooth.faces()) {
    const auto fate = spoilt ? random() % 40 : 40;
    if (fate == 0) continue;
    if (fate == 1) std::swap(face[0], face[1]);
    if (fate == 2) faces.push_back(face);
    faces.push_back(face);
  }
  return {smooth.vertices(), std::move(faces)};
}

/// A ball deep in the ground or at its surface, that leaves, goes deeper or sweeps along.
Moving<Sphere> deep_cast(Random& random, const Mesh& mesh) {
  const Triangle t = mesh.triangle(random() % mesh.size());
  const Vector normal = t.area_vector().normalized(), away = direction(random);
  const double r = log_uniform(random, 1e-3, 30), length = log_uniform(random, 1e-4, 4);
  if (random() % 2) return {Sphere{t.a + away * r * uniform(random, 0, 1), r}, length * direction(random)};
  const Vector along = normal.cross(direction(random)).normalized();
  const double height = r * (1 + uniform(random, -1, 0.1) * log_uniform(random, 1e-12, 1));
  return {Sphere{t.a + normal * height, r}, length * (along + log_uniform(random, 1e-6, 0.5) * away)};
}

bvh::NormalCones cones_of(const Bvh& tree) { return {*tree.parts().surface, tree.parts().space}; }

/// The triangle with this number.
std::span<const bvh::Place> place(const Bvh& tree, std::uint32_t number) {
  const auto places = tree.parts().surface->places();
  std::size_t at = 0;
  while (places[at].number != number) ++at;
  return places.subspan(at, 1);
}

}  // namespace

TEST_CASE("What the fast tree leaves out for its normals, the plain tree finds not to be touched") {
  const std::uint64_t seed = GENERATE(range(1u, 120u));
  Random random(seed);
  const Mesh mesh = hills(random);
  const PlainBvh plain(mesh);
  const Bvh fast(mesh);
  for (int i = 0; i < 100; ++i) {
    const Moving<Sphere> moving = deep_cast(random, mesh);
    const auto expected = sweep(moving, plain);
    CAPTURE(seed, i, told(expected), told(sweep(moving, fast)));
    REQUIRE(same(sweep(moving, fast), expected));
    REQUIRE(same(bvh::sweep(moving, fast, bvh::portable_walker), expected));
  }
}

TEST_CASE("Inside a flat floor the cone is as narrow as its margin; at the rim there is none") {
  const Bvh floor(grid(4, [](double, double) { return 0.0; }));
  const auto cones = cones_of(floor);
  CHECK(cones.cosine_around({0, 0, 1}, place(floor, 2 * (4 + 1))) ==
        Approx(1 - bvh::NormalCones::margin).epsilon(1e-6));
  CHECK(cones.cosine_around({0, 0, 1}, place(floor, 0)) == 0);
}

TEST_CASE("A cone about another axis is wider by the angle between the two") {
  const Bvh floor(grid(4, [](double, double) { return 0.0; }));
  const float tilt = 0.3F;
  const float cosine =
      cones_of(floor).cosine_around({std::sin(tilt), 0, std::cos(tilt)}, place(floor, 2 * (4 + 1)));
  CHECK(cosine == Approx(std::cos(tilt) - bvh::NormalCones::margin).epsilon(1e-5));
}

TEST_CASE("Where a triangle is turned over, missing, there twice, or thin, there is no cone") {
  const Mesh flat = grid(4, [](double, double) { return 0.0; });
  const std::uint32_t middle = 2 * (4 + 1), beside = middle + 1;
  auto faces = flat.faces();
  auto points = flat.vertices();
  SECTION("turned over") { std::swap(faces[beside][0], faces[beside][1]); }
  SECTION("missing") { faces[beside] = {0, 0, 0}; }
  SECTION("there twice") { faces.push_back(faces[beside]); }
  SECTION("thin") { points[faces[beside][2]] = points[faces[beside][1]] + Vector(1e-3, 1e-3, 0); }
  const Bvh spoilt(Mesh(points, faces));
  CHECK(cones_of(spoilt).cosine_around({0, 0, 1}, place(spoilt, middle)) == 0);
}
