#include "first_contact/mesh_io/mesh_defects.hpp"

#include "catch.hpp"
#include "test_meshes.hpp"

using namespace first_contact;

TEST_CASE("Nothing is wrong with a cube, nor with a floor that ends") {
  CHECK(diagnose(test_meshes::cube()).none());
  CHECK(diagnose(test_meshes::tiled_floor(3)).none());
}

TEST_CASE("A triangle with two equal corners, or with three on a line, has no area, a thin one has") {
  const std::vector<Point> vertices{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1e-12, 0}};
  CHECK(diagnose(Mesh(vertices, {{0, 1, 1}})).degenerate == 1);
  CHECK(diagnose(Mesh(vertices, {{0, 1, 2}})).degenerate == 1);
  CHECK(diagnose(Mesh(vertices, {{0, 1, 3}})).degenerate == 1);
  CHECK(diagnose(Mesh(vertices, {{0, 3, 4}})).none());
}

TEST_CASE("What has no area is known at any scale") {
  for (const double scale : {1e-150, 1e-6, 1e6, 1e150}) {
    CAPTURE(scale);
    const std::vector<Point> vertices{{0, 0, 0}, {scale, scale, 0}, {3 * scale, 3 * scale, 0}, {0, scale, 0}};
    CHECK(diagnose(Mesh(vertices, {{0, 1, 2}})).degenerate == 1);
    CHECK(diagnose(Mesh(vertices, {{0, 1, 3}})).none());
  }
}

TEST_CASE("A triangle is there twice if its corners are, in any order and under any number") {
  const std::vector<Point> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  CHECK(diagnose(Mesh(vertices, {{0, 1, 2}, {2, 1, 0}, {1, 3, 0}})).duplicate == 2);
  CHECK(diagnose(Mesh(vertices, {{0, 1, 2}, {2, 1, 0}, {1, 3, 0}})).non_manifold == 0);
}

TEST_CASE("An edge of three triangles is not of a surface") {
  const std::vector<Point> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  CHECK(diagnose(Mesh(vertices, {{0, 1, 2}, {0, 1, 3}})).none());
  CHECK(diagnose(Mesh(vertices, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}})).non_manifold == 1);
}

TEST_CASE("A mesh without triangles has nothing wrong with it") { CHECK(diagnose(Mesh({}, {})).none()); }
