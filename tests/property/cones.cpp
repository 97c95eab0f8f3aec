#include "first_contact/bvh/build/cones.hpp"

#include <cmath>
#include <vector>

#include "catch.hpp"
#include "chance.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/bvh/cast/parts.hpp"
#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "first_contact/program/terrain.hpp"
#include "first_contact/trees/plain_bvh.hpp"
#include "property/same_contact.hpp"

using namespace first_contact;

namespace {

/// Hills, some gentle, some rough, some with a crease; some triangles turned over, missing or there twice.
Mesh hills(Chance& chance) {
  const auto n = static_cast<std::uint32_t>(3 + chance.pick(25));
  const double wave = chance.uniform(0.5, 6), size = chance.log_uniform(1e-3, 3) / wave,
               noise = chance.log_uniform(1e-6, 1) / n;
  const bool creased = chance.pick(2);
  const Mesh smooth = program::height_field(n, 2, [&](double x, double y) {
    const double hill = std::sin(wave * x) * (creased ? 1 : std::cos(wave * y));
    return size * (creased ? std::abs(hill) : hill) + noise * chance.uniform(-1, 1);
  });
  std::vector<Mesh::Face> faces;
  const bool spoilt = chance.pick(2);
  for (Mesh::Face face : smooth.faces()) {
    const std::size_t fate = spoilt ? chance.pick(40) : 40;
    if (fate == 0) continue;
    if (fate == 1) std::swap(face[0], face[1]);
    if (fate == 2) faces.push_back(face);
    faces.push_back(face);
  }
  return {smooth.vertices(), std::move(faces)};
}

/// A ball deep in the ground or at its surface, that leaves, goes deeper or sweeps along.
Moving<Sphere> deep_cast(Chance& chance, const Mesh& mesh) {
  const Triangle t = mesh.triangle(chance.pick(mesh.size()));
  const Vector normal = t.area_vector().normalized(), away = chance.direction();
  const double r = chance.log_uniform(1e-3, 30), length = chance.log_uniform(1e-4, 4);
  if (chance.pick(2)) return {Sphere{t.a + away * r * chance.uniform(0, 1), r}, length * chance.direction()};
  const Vector along = normal.cross(chance.direction()).normalized();
  const double height = r * (1 + chance.uniform(-1, 0.1) * chance.log_uniform(1e-12, 1));
  return {Sphere{t.a + normal * height, r}, length * (along + chance.log_uniform(1e-6, 0.5) * away)};
}

Mesh flat_floor() {
  return program::height_field(4, 2, [](double, double) { return 0.0; });
}

/// The cosine of the cone of one triangle about an axis.
float cosine_around(const Eigen::Vector3f& axis, const Mesh& mesh, std::uint32_t triangle) {
  const bvh::Surface surface(mesh);
  return bvh::NormalCones(surface, bvh::Space(mesh)).cosine_around(axis, std::span(&triangle, 1));
}

}  // namespace

TEST_CASE("What the fast tree leaves out for its normals, the plain tree finds not to be touched") {
  const std::uint64_t seed = GENERATE(range(1u, 120u));
  Chance chance(seed);
  const Mesh mesh = hills(chance);
  const PlainBvh plain(mesh);
  const Bvh fast(mesh);
  const auto walkers = bvh::all_walkers();
  for (int i = 0; i < 100; ++i) {
    const Moving<Sphere> moving = deep_cast(chance, mesh);
    const auto expected = sweep(moving, plain);
    CAPTURE(seed, i, told(expected), told(sweep(moving, fast)));
    REQUIRE(same(sweep(moving, fast), expected));
    for (const bvh::Walker* walker : walkers) {
      CAPTURE(walker->name);
      REQUIRE(same(bvh::sweep(moving, fast.parts(), *walker), expected));
    }
  }
}

TEST_CASE("Inside a flat floor the cone is as narrow as its margin, at the rim there is none") {
  const Mesh floor = flat_floor();
  CHECK(cosine_around({0, 0, 1}, floor, 2 * (4 + 1)) == Approx(1 - bvh::NormalCones::margin).epsilon(1e-6));
  CHECK(cosine_around({0, 0, 1}, floor, 0) == 0);
}

TEST_CASE("A cone about another axis is wider by the angle between the two") {
  const float tilt = 0.3F;
  const float cosine = cosine_around({std::sin(tilt), 0, std::cos(tilt)}, flat_floor(), 2 * (4 + 1));
  CHECK(cosine == Approx(std::cos(tilt) - bvh::NormalCones::margin).epsilon(1e-5));
}

TEST_CASE("Where a triangle is turned over, missing, there twice, or thin, there is no cone") {
  const Mesh flat = flat_floor();
  const std::uint32_t middle = 2 * (4 + 1), beside = middle + 1;
  auto faces = flat.faces();
  auto points = flat.vertices();
  SECTION("turned over") { std::swap(faces[beside][0], faces[beside][1]); }
  SECTION("missing") { faces[beside] = {0, 0, 0}; }
  SECTION("there twice") { faces.push_back(faces[beside]); }
  SECTION("thin") { points[faces[beside][2]] = points[faces[beside][1]] + Vector(1e-3, 1e-3, 0); }
  CHECK(cosine_around({0, 0, 1}, Mesh(points, faces), middle) == 0);
}
