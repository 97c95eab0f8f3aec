#include "first_contact/sweep/box_box.hpp"

#include "catch.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/sweep/box_mesh.hpp"
#include "test_meshes.hpp"

using namespace first_contact;

namespace {

const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
const Box slab{{0, 0, -0.5}, 8 * x, 8 * y, z};  // its top is z = 0

Box cube_at(const Point& center) { return {center, 2 * x, 2 * y, 2 * z}; }
const Rigid on_edge = Rigid::turned(y, std::numbers::pi / 4);
const Rigid on_vertex = Rigid::turned(Vector(1, -1, 0), std::atan(std::sqrt(2.0)));

}  // namespace

TEST_CASE("A box that falls on a box lands on its face, its edge or its vertex") {
  const auto flat = sweep(Moving{cube_at({1, 1, 5}), Vector(0, 0, -8)}, slab);
  REQUIRE(flat);
  CHECK(flat->time == 0.5);
  CHECK(flat->normal == z);
  CHECK((flat->point() - Point(1, 1, 0)).norm() < 1e-14);
  CHECK(flat->feature == Feature::face);
  for (const Rigid& turn : {on_edge, on_vertex}) {
    const Box tilted = Rigid::moved_by({1, 1, 5}).box(turn.box(cube_at({0, 0, 0})));
    const auto contact = sweep(Moving{tilted, Vector(0, 0, -8)}, slab);
    REQUIRE(contact);
    CHECK(contact->time == Approx((5 - tilted.effective_radius(z)) / 8).epsilon(1e-15));
    CHECK((contact->normal - z).norm() < 1e-15);
    CHECK((contact->point() - Point(1, 1, 0)).norm() < 1e-14);
  }
}

TEST_CASE("Over the rim of a box, the point is the middle of what both share") {
  const auto contact = sweep(Moving{cube_at({4.5, 0, 5}), Vector(0, 0, -8)}, slab);
  REQUIRE(contact);
  CHECK((contact->point() - Point(3.75, 0, 0)).norm() < 1e-13);
  CHECK_FALSE(sweep(Moving{cube_at({5.001, 0, 5}), Vector(0, 0, -8)}, slab));
}

TEST_CASE("Two edges that cross touch in one point, with the normal across both") {
  const Box lower = Rigid::turned(x, std::numbers::pi / 4).box({{0, 0, 0}, 6 * x, y, z});
  const Box upper = Rigid::moved_by({0.25, 0.5, 4}).box(on_edge.box({{0, 0, 0}, x, 6 * y, z}));
  const auto contact = sweep(Moving{upper, Vector(0, 0, -4)}, lower);
  REQUIRE(contact);
  CHECK(contact->time == Approx(1 - std::sqrt(2.0) / 4));
  CHECK((contact->normal - z).norm() < 1e-15);
  CHECK((contact->point() - Point(0.25, 0, std::sqrt(0.5))).norm() < 1e-13);
  CHECK(contact->feature == Feature::edge);
}

TEST_CASE("Boxes that touch are in contact if they approach, and not if they slide or leave") {
  const Box resting = cube_at({0, 0, 1});
  CHECK(sweep(Moving{resting, Vector(0, 0, -1)}, slab)->time == 0);
  CHECK_FALSE(sweep(Moving{resting, Vector(9, 0, 0)}, slab));
  CHECK_FALSE(sweep(Moving{resting, Vector(1, 0, 1)}, slab));
  CHECK_FALSE(sweep(Moving{resting, Vector(0, 0, 0)}, slab));
  CHECK(overlap(resting, slab));
  CHECK_FALSE(overlap(cube_at({0, 0, 1.001}), slab));
}

TEST_CASE("Boxes that overlap can get out of each other, and no deeper") {
  const Box sunk = cube_at({0, 0, 0.75});
  const auto deeper = sweep(Moving{sunk, Vector(1, 0, -1)}, slab);
  REQUIRE(deeper);
  CHECK(deeper->time == 0);
  CHECK(deeper->normal == z);
  CHECK_FALSE(sweep(Moving{sunk, Vector(1, 0, 1)}, slab));
  CHECK_FALSE(sweep(Moving{sunk, Vector(1, 0, 0)}, slab));
  CHECK(sweep(Moving{cube_at({0, 0, 0}), Vector(0, 1, 0)}, cube_at({0, 0, 0}))->normal == -y);  // concentric
}

TEST_CASE("Flat boxes, rods and points meet as the sheets, rods and points that they are") {
  const Box sheet{{0, 0, 2}, 2 * x, 2 * y, {0, 0, 0}}, rod{{0, 0, 2}, 2 * y, {0, 0, 0}, {0, 0, 0}};
  const Box speck{{0.25, 0, 2}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const Box floor{{0, 0, 0}, 8 * x, 8 * y, {0, 0, 0}}, wire{{0, 0, 0}, 8 * x, {0, 0, 0}, {0, 0, 0}};
  for (const Box& falling : {sheet, rod, speck})
    for (const Box& below : {floor, wire}) {
      const auto contact = sweep(Moving{falling, Vector(0, 0, -4)}, below);
      REQUIRE(contact);
      CHECK(contact->time == 0.5);
      CHECK((contact->normal - z).norm() < 1e-15);
      CHECK_FALSE(sweep(Moving{falling, Vector(20, 0, -4)}, below));
    }
  const Box beside{{9, 0, 0}, 2 * x, 2 * y, {0, 0, 0}};  // in the floor's own plane
  CHECK(sweep(Moving{beside, Vector(-8, 0, 0)}, floor)->time == 0.5);
  CHECK_FALSE(sweep(Moving{beside, Vector(-3, 0, 0)}, floor));
  CHECK_FALSE(sweep(Moving{beside, Vector(-8, 20, 0)}, floor));
}

TEST_CASE("A box against a triangle, and against a floor of them, lands as on a plane") {
  const Mesh floor = test_meshes::tiled_floor(4);
  const Box tilted = Rigid::moved_by({1.5, 2.25, 5}).box(on_vertex.box(cube_at({0, 0, 0})));
  const double time = (5 - tilted.effective_radius(z)) / 8;
  const auto contact = sweep(Moving{tilted, Vector(0, 0, -8)}, Environment(floor));
  REQUIRE(contact);
  CHECK(contact->time == Approx(time).epsilon(1e-15));
  CHECK((contact->normal - z).norm() < 1e-15);
  CHECK((contact->point() - Point(1.5, 2.25, 0)).norm() < 1e-14);
  CHECK(contact->feature == Feature::face);
  const auto single = sweep(Moving{tilted, Vector(0, 0, -8)}, floor.triangle(contact->triangle));
  REQUIRE(single);
  CHECK(single->time == contact->time);
  CHECK_FALSE(overlap(tilted, floor));
  CHECK(overlap(cube_at({2, 2, 0.5}), Environment(floor)));
}

TEST_CASE("A box that slides along a floor of many triangles meets none of their seams") {
  const Environment floor(test_meshes::tiled_floor(8));
  CHECK_FALSE(sweep(Moving{cube_at({1.3, 1.7, 1}), Vector(5, 4, 0)}, floor));
  CHECK(sweep(Moving{cube_at({1.3, 1.7, 1}), Vector(5, 4, -0.001)}, floor)->normal == z);
}
