#include "first_contact/geometry/mesh_edges.hpp"

#include <map>

#include "catch.hpp"
#include "test_meshes.hpp"

using namespace first_contact;

namespace {

std::map<EdgeKind, int> kinds(const Mesh& mesh) {
  std::map<EdgeKind, int> count;
  const MeshEdges topology(mesh);
  for (const auto& edge : topology.edges()) ++count[edge.kind];
  return count;
}

Mesh turned(const Mesh& mesh, double angle, const Vector& shift = {0, 0, 0}) {
  const Eigen::AngleAxisd rotation(angle, Vector(1, -2, 3).normalized());
  return test_meshes::mapped(mesh, [&](const Point& p) { return Point(rotation * p + shift); });
}

}  // namespace

TEST_CASE("A cube has twelve convex edges, and a flat one across each side") {
  CHECK(kinds(test_meshes::cube()) == std::map<EdgeKind, int>{{EdgeKind::convex, 12}, {EdgeKind::flat, 6}});
}
TEST_CASE("A cube inside out has concave edges") {
  const Mesh cube = test_meshes::cube();
  std::vector<Mesh::Face> faces = cube.faces();
  for (auto& face : faces) std::swap(face[1], face[2]);
  CHECK(kinds({cube.vertices(), faces}) ==
        std::map<EdgeKind, int>{{EdgeKind::concave, 12}, {EdgeKind::flat, 6}});
}
TEST_CASE("A ridge is convex, a valley concave, and the rim of an open surface its boundary") {
  CHECK(kinds(test_meshes::bend(-0.5))[EdgeKind::convex] == 1);
  CHECK(kinds(test_meshes::bend(0.5))[EdgeKind::concave] == 1);
  CHECK(kinds(test_meshes::bend(0.5))[EdgeKind::boundary] == 6);
}
TEST_CASE("Three faces at one edge are no manifold") {
  const Mesh book{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                  {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  CHECK(kinds(book)[EdgeKind::non_manifold] == 1);
}
TEST_CASE("A sheet folded back on itself has a convex edge, for it is as sharp as a knife") {
  const Mesh knife{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  CHECK(kinds(knife)[EdgeKind::convex] == 1);
}
TEST_CASE("Two faces whose normals point to opposite sides of a plane still meet in a flat edge") {
  const Mesh floor{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}}, {{0, 2, 1}, {0, 3, 1}}};
  CHECK(kinds(floor)[EdgeKind::flat] == 1);
}
TEST_CASE("A degenerate face has edges but continues no other face") {
  const Mesh mesh{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0.5, 0}}, {{0, 2, 1}, {0, 1, 3}}};
  CHECK(kinds(mesh) == std::map<EdgeKind, int>{{EdgeKind::boundary, 5}});
}
TEST_CASE("Vertices at the same position are one vertex, also with a zero of the other sign") {
  const Mesh cube = test_meshes::cube();
  CHECK(kinds(test_meshes::unwelded(cube)) == kinds(cube));
  const Mesh hinge{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-0.0, 1, 0}, {0, -0.0, 0}, {-1, 0, 1}},
                   {{0, 2, 1}, {3, 5, 4}}};
  CHECK(kinds(hinge)[EdgeKind::boundary] == 4);
  CHECK(MeshEdges(hinge).representative(4) == 0);
}
TEST_CASE("Every vertex of a cube knows its edges and its faces") {
  const MeshEdges edges(test_meshes::cube());
  std::size_t edge_ends = 0, corners = 0;
  for (std::uint32_t vertex = 0; vertex < 8; ++vertex) {
    edge_ends += edges.edges_at(vertex).size();
    corners += edges.faces_at(vertex).size();
  }
  CHECK(edge_ends == 2 * 18);
  CHECK(corners == 3 * 12);
}
TEST_CASE("An edge goes from the vertex that comes first in x, then y, then z") {
  const Mesh mesh = turned(test_meshes::cube(), 0.7);
  const MeshEdges topology(mesh);
  for (const auto& edge : topology.edges())
    CHECK(comes_before(mesh.vertices()[edge.vertices[0]], mesh.vertices()[edge.vertices[1]]));
}

TEST_CASE("A turned floor is flat: the tolerance covers the rounding of its normals") {
  for (int i = 1; i < 200; ++i) {
    const auto found = kinds(turned(test_meshes::tiled_floor(3), 0.037 * i));
    // The turned corners are themselves rounded; edges bent by that alone may show, but as hardly any of 33.
    CHECK(found.at(EdgeKind::flat) + (found.count(EdgeKind::convex) ? found.at(EdgeKind::convex) : 0) +
              (found.count(EdgeKind::concave) ? found.at(EdgeKind::concave) : 0) ==
          21);
    CHECK(found.at(EdgeKind::flat) >= 20);
  }
}
TEST_CASE("A bend of a thousand roundings is not flat") {
  CHECK(kinds(test_meshes::bend(1e-12))[EdgeKind::flat] == 2);  // the diagonals alone
}
TEST_CASE("The kinds of edges do not change with the scale, by a power of two") {
  for (const double scale : {std::ldexp(1.0, -90), std::ldexp(1.0, 90)}) {
    const Mesh mesh = turned(test_meshes::cube(), 0.3);
    CHECK(kinds(test_meshes::mapped(mesh, [&](const Point& p) { return Point(scale * p); })) == kinds(mesh));
  }
}

TEST_CASE("The corners of a cube stand out, a peak and a pit do") {
  const MeshEdges cube(test_meshes::cube());
  for (std::uint32_t vertex = 0; vertex < 8; ++vertex) CHECK_FALSE(cube.buried(vertex));
  CHECK_FALSE(MeshEdges(test_meshes::fan({-1, -1, -1, -1, -1})).buried(0));
  CHECK_FALSE(MeshEdges(test_meshes::fan({1, 1, 1})).buried(0));
}
TEST_CASE("A vertex within a flat floor is buried, and so is a saddle, as in figure 9") {
  CHECK(MeshEdges(test_meshes::fan({0, 0, 0, 0, 0, 0})).buried(0));
  CHECK(MeshEdges(test_meshes::fan({1, -1, 1, -1})).buried(0));
  CHECK(MeshEdges(test_meshes::fan({1, -1, 1, -1, 1, -1})).buried(0));
}
TEST_CASE("A vertex on a straight edge, not at its end, is buried") {
  const Mesh ridge{{{0, -1, 0}, {0, 0, 0}, {0, 1, 0}, {1, 0, -1}, {-1, 0, -1}},
                   {{0, 3, 1}, {1, 3, 2}, {0, 1, 4}, {1, 2, 4}}};
  CHECK(MeshEdges(ridge).buried(1));
  CHECK_FALSE(MeshEdges(ridge).buried(0));
}
TEST_CASE("The corners of a single triangle stand out, a notch in a flat sheet does not") {
  const Mesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, -1, 0}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
  const MeshEdges edges(sheet);
  CHECK(edges.buried(0));
  for (std::uint32_t vertex = 1; vertex < 6; ++vertex) CHECK_FALSE(edges.buried(vertex));
}
TEST_CASE("A vertex of no face is buried, a face that has shrunk to a point is not") {
  const MeshEdges edges(Mesh{{{0, 0, 0}, {5, 5, 5}}, {{0, 0, 0}}});
  CHECK_FALSE(edges.buried(0));
  CHECK(edges.buried(1));
}
