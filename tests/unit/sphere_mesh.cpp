#include "first_contact/sweep/sphere_mesh.hpp"

#include "catch.hpp"
#include "test_meshes.hpp"

using namespace first_contact;

namespace {

std::optional<Contact> cast(const Mesh& mesh, const Point& from, const Point& to, double radius) {
  return sweep(Moving<Sphere>{{from, radius}, to - from}, Environment(mesh));
}

const Mesh cube = test_meshes::cube();

}  // namespace

TEST_CASE("A sphere meets the face, the edge or the vertex of a cube, whichever is first") {
  CHECK(cast(cube, {0.3, 0.2, 4}, {0.3, 0.2, 0}, 1)->feature == Feature::face);
  CHECK(cast(cube, {0.3, 0.2, 4}, {0.3, 0.2, 0}, 1)->time == 0.5);
  CHECK(cast(cube, {1.6, 0.2, 4}, {1.6, 0.2, 0}, 1)->feature == Feature::edge);
  CHECK(cast(cube, {1.6, 0.2, 4}, {1.6, 0.2, 0}, 1)->time == Approx((4 - 1.8) / 4));
  CHECK(cast(cube, {1.48, 1.36, 4}, {1.48, 1.36, 0}, 1)->feature == Feature::vertex);
  CHECK_FALSE(cast(cube, {1.8, 1.8, 4}, {1.8, 1.8, 0}, 1));
}
TEST_CASE("The earliest of all faces counts, not the first in the list") {
  const Mesh shelves{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, {-9, -9, 1}, {9, -9, 1}, {0, 9, 1}},
                     {{0, 1, 2}, {3, 4, 5}}};
  CHECK(cast(shelves, {0, 0, 3}, {0, 0, -1}, 0.5)->triangle == 1);
  CHECK(cast(shelves, {0, 0, -2}, {0, 0, 2}, 0.5)->triangle == 0);
}
TEST_CASE("A triangle of a mesh that has shrunk to a segment or to a point is one") {
  const Mesh shrunk{{{1, 2, 3}, {1, 2, 3}, {0, 0, 9}, {2, 0, 9}, {1, 0, 9}}, {{0, 1, 0}, {2, 3, 4}}};
  CHECK(cast(shrunk, {1, 2, 6}, {1, 2, 2}, 1)->time == 0.5);
  CHECK(cast(shrunk, {1, 2, 6}, {1, 2, 2}, 1)->feature == Feature::vertex);
  CHECK(cast(shrunk, {0.5, 3, 9}, {0.5, -1, 9}, 1)->time == 0.5);
}
TEST_CASE("An edge that is met before a face hides it") {  // and, once passed, does not
  const Mesh step{{{0, 0, 0}, {-6, -2, 0}, {-6, 2, 0}, {1, -2, -2}, {1, 2, -2}, {1, 0, 2}},
                  {{0, 1, 2}, {3, 4, 5}}};
  CHECK(cast(step, {-0.8, 0, 0.31}, {3.2, 0, 0.01}, 0.25)->time < 0.2);
  CHECK(cast(step, {-0.8, 0, 0.41}, {3.2, 0, 0.25}, 0.25)->triangle == 1);
}
TEST_CASE("The touched triangle is the lowest of those that share the touched point") {
  CHECK(cast(cube, {0, 0, 4}, {0, 0, 0}, 1)->triangle == 2);          // the diagonal of the top
  CHECK(cast(cube, {1.6, 0.2, 4}, {1.6, 0.2, 0}, 1)->triangle == 2);  // an edge, of 2 and 11
  CHECK(cast(cube, {1.48, 1.36, 4}, {1.48, 1.36, 0}, 1)->triangle == 2);
  CHECK(cast(cube, {0.3, 0.9, 4}, {0.3, 0.9, 0}, 1)->triangle == 3);
}
TEST_CASE("A tiled floor is a floor: seams are faces") {
  const Mesh floor = test_meshes::tiled_floor(4);
  for (const Point& p :
       {Point(2, 2, 0), Point(1.5, 1.5, 0), Point(2, 1.25, 0), Point(0, 0, 0), Point(4, 2.5, 0)}) {
    const auto contact = cast(floor, p + Vector(0, 0, 2), p - Vector(0, 0, 2), 0.5);
    REQUIRE(contact);
    CHECK(contact->feature == Feature::face);
    CHECK(contact->normal == Vector(0, 0, 1));
    CHECK(contact->time == 0.375);
  }
}
TEST_CASE("A sphere that slides along a tiled floor never trips over a seam") {
  const Mesh floor = test_meshes::tiled_floor(4);
  CHECK_FALSE(cast(floor, {0.5, 0.25, 0.5}, {3.5, 3.75, 0.5}, 0.5));
  CHECK_FALSE(cast(floor, {0.5, 0.25, 0.25}, {3.5, 3.75, 0.25}, 0.5));  // half sunk
  CHECK_FALSE(cast(floor, {0.5, 0.25, 0.25}, {9.5, 3.75, 0.5}, 0.5));   // half sunk, and leaving over the rim
  CHECK_FALSE(cast(cube, {0, 0.1, 1.5}, {8, 0.1, 1.5}, 0.5));           // off the top of the cube
  CHECK_FALSE(cast(cube, {1.5, 0.1, -4}, {1.5, 0.1, 4}, 0.5));  // along its side, touching it in passing
}
TEST_CASE(
    "A sphere in a valley meets the faces and never the edge, from the other side the edge, as in figure 8") {
  const Mesh valley = test_meshes::bend(0.75);
  const auto inside = cast(valley, {0.25, 2, 4}, {0.25, 2, 0}, 1);
  REQUIRE(inside);
  CHECK(inside->feature == Feature::face);
  CHECK(cast(valley, {0, 2, 4}, {0, 2, 0}, 1)->feature == Feature::face);
  CHECK(cast(valley, {0, 2, -4}, {0, 2, 0}, 1)->feature == Feature::edge);
}
TEST_CASE("A sphere over a saddle meets what lies around the buried vertex, as in figure 9") {
  const Mesh saddle = test_meshes::fan({0.5, -0.5, 0.5, -0.5});
  const auto contact = cast(saddle, {0, 0, 3}, {0, 0, -1}, 1);
  REQUIRE(contact);
  CHECK(contact->feature != Feature::vertex);
}
TEST_CASE("A sphere overlapping a mesh is judged feature by feature") {
  CHECK(cast(cube, {0.3, 0.2, 1.5}, {0.3, 0.2, 1.4}, 1)->time == 0);
  CHECK_FALSE(cast(cube, {0.3, 0.2, 1.5}, {0.3, 0.2, 9}, 1));
  // Leaving the top while it nears an edge of it: the edge is not the nearest there, so there is nothing to
  // meet.
  CHECK_FALSE(cast(cube, {0.9, 0.2, 1.5}, {1.9, 0.2, 1.6}, 1));
  // Outside the edge, nearing the corner line: deeper.
  CHECK(cast(cube, {1.5, 0.2, 1.5}, {1.4, 0.2, 1.4}, 1)->feature == Feature::edge);
  CHECK_FALSE(cast(cube, {1.5, 0.2, 1.5}, {1.6, 0.2, 1.6}, 1));
  // Leaving the floor, and up against a ceiling.
  const Mesh hall{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, {-9, -9, 4}, {9, -9, 4}, {0, 9, 4}},
                  {{0, 1, 2}, {3, 4, 5}}};
  CHECK(cast(hall, {0, 0, 0.5}, {0, 0, 4.5}, 1)->time == Approx(2.5 / 4));
}
TEST_CASE("A sphere inside a closed surface meets it from inside") {
  const auto contact = cast(cube, {0, 0, 0}, {0.2, 0.1, 2}, 0.5);
  REQUIRE(contact);
  CHECK(contact->time == 0.25);
  CHECK(contact->normal == Vector(0, 0, -1));
  CHECK_FALSE(overlap(Sphere{{0, 0, 0}, 0.5}, cube));
  CHECK(overlap(Sphere{{0, 0, 0}, 1}, cube));
}
TEST_CASE(
    "An edge and a face of no thickness: a sphere in a corner of faces that overlap the start is free to "
    "leave") {
  const Mesh corner{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
  CHECK_FALSE(cast(corner, {0.5, 0.5, 0.5}, {1, 1, 1}, 1));
  CHECK(cast(corner, {0.5, 0.5, 0.5}, {0.4, 0.5, 0.5}, 1)->normal == Vector(1, 0, 0));
}
TEST_CASE("A centre on the surface has its normal against the motion, on a seam as well") {
  CHECK(cast(cube, {0, 0, 1}, {0, 0, 0}, 0.5)->normal == Vector(0, 0, 1));
  CHECK(cast(cube, {0, 0, 1}, {0, 0, 2}, 0.5)->normal == Vector(0, 0, -1));
  CHECK_FALSE(cast(cube, {0, 0, 1}, {0.25, 0.125, 1}, 0.5));
}
TEST_CASE("A sphere at rest has no contact with a mesh, and nothing is met in an empty one") {
  CHECK_FALSE(cast(cube, {1, 0.2, 0}, {1, 0.2, 0}, 0.5));
  CHECK_FALSE(cast(Mesh{{}, {}}, {0, 0, 0}, {1, 0, 0}, 0.5));
}
TEST_CASE("An environment overlaps what its mesh does") {
  const Sphere touching{{1.6, 0.2, 1.2}, 1}, apart{{1.6, 0.2, 2.2}, 1};
  CHECK(overlap(touching, cube));
  CHECK(overlap(touching, Environment(cube)));
  CHECK_FALSE(overlap(apart, Environment(cube)));
}
TEST_CASE("A sliver between two tiles of a floor lets no sphere through") {
  const double gap = 1e-9;
  const Mesh floor{{{-4, -4, 0}, {0, -4, 0}, {0, 4, 0}, {gap, 4, 0}, {4, 4, 0}, {gap, -4, 0}},
                   {{0, 1, 2}, {1, 5, 3}, {1, 3, 2}, {5, 4, 3}}};
  for (const double x : {-gap, 0.0, gap / 4, gap / 2, gap, 2 * gap})
    for (const double radius : {0.0, 1e-12, 1e-6, 1e-3, 1.0, 100.0}) {
      const auto contact = cast(floor, {x, 0.3, radius + 1}, {x, 0.3, radius - 1}, radius);
      REQUIRE(contact);
      CHECK(contact->time == Approx(0.5).epsilon(1e-13));
      CHECK(contact->feature == Feature::face);
    }
}
