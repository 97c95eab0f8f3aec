// Does a sphere share a point with a surface? The trees say what a loop over all triangles says.
#include "catch.hpp"
#include "digest/shapes.hpp"
#include "first_contact/bvh/bvh.hpp"
#include "first_contact/sweep/sphere_mesh.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"
#include "first_contact/trees/plain_bvh.hpp"
#include "test_meshes.hpp"

using namespace first_contact;
using digest::Dice;

namespace {

bool by_loop(const Sphere& sphere, const Mesh& mesh) {
  bool touching = false;
  for (const Triangle& triangle : mesh.triangles()) touching = touching || overlap(sphere, triangle);
  return touching;
}

// Anywhere, or as far from a vertex as its radius is, up to a few last bits.
Sphere ball_near(Dice& dice, const Mesh& mesh, double unit) {
  const Point& vertex = mesh.vertices()[dice.bits() % mesh.vertices().size()];
  return (dice.one_in(2) ? digest::ball(dice, unit) : digest::grazing_ball(dice, vertex, unit)).shape;
}

Mesh shards(Dice& dice, int count, double unit) {
  std::vector<Point> vertices;
  std::vector<Mesh::Face> faces;
  for (const Triangle& t : digest::soup(dice, count, unit)) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {t.a, t.b, t.c});
    faces.push_back({first, first + 1, first + 2});
  }
  return {std::move(vertices), std::move(faces)};
}

}  // namespace

TEST_CASE("A sphere overlaps a surface of trees if it overlaps one of the triangles, be it by a last bit") {
  Dice dice(41);
  int touching = 0, apart = 0;
  for (int scene = 0; scene < 80; ++scene) {
    const double unit = dice.one_in(3) ? std::ldexp(1.0, dice.whole(-895, 990)) : 1;
    const Mesh mesh =
        dice.one_in(2) ? digest::ground(dice, dice.whole(1, 8), unit) : shards(dice, dice.whole(1, 60), unit);
    const Bvh fast(mesh);
    const PlainBvh plain(mesh);
    for (int i = 0; i < 100; ++i) {
      const Sphere ball = ball_near(dice, mesh, unit);
      const bool truth = by_loop(ball, mesh);
      (truth ? touching : apart) += 1;
      CAPTURE(scene, i, unit);
      REQUIRE(overlap(ball, fast) == truth);
      REQUIRE(overlap(ball, plain) == truth);
      REQUIRE(overlap(ball, Environment(mesh)) == truth);
    }
  }
  CHECK(touching > 1000);
  CHECK(apart > 1000);
}

TEST_CASE(
    "A point overlaps a tree's surface where it lies on it, and nothing overlaps a surface of nothing") {
  const Mesh floor = test_meshes::tiled_floor(9);
  CHECK(overlap(Point(1.25, 2, 0), Bvh(floor)));
  CHECK_FALSE(overlap(Point(1.25, 2, 0x1p-30), Bvh(floor)));
  CHECK_FALSE(overlap(Sphere{{0, 0, 0}, 1e300}, Bvh(Mesh({}, {}))));
  CHECK_FALSE(overlap(Sphere{{0, 0, 0}, 1e300}, PlainBvh(Mesh({}, {}))));
}

TEST_CASE("A sphere as large as 2^1000, or as far away, overlaps a small surface or does not") {
  const Mesh floor = test_meshes::tiled_floor(9);
  const Bvh fast(floor);
  const PlainBvh plain(floor);
  for (const double size : {1e10, 1e100, largest_length}) {
    CAPTURE(size);
    CHECK(overlap(Sphere{{0, 0, 0}, size}, fast));
    CHECK(overlap(Sphere{{0, 0, 0}, size}, plain));
    CHECK(overlap(Sphere{{0, 0, size}, size}, fast));
    CHECK_FALSE(overlap(Sphere{{0, 0, size}, size / 2}, fast));
    CHECK_FALSE(overlap(Sphere{{0, 0, size}, size / 2}, plain));
  }
}
