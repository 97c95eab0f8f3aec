#include "plain_edges.hpp"

#include <algorithm>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/transform.hpp"
#include "first_contact/program/random.hpp"
#include "scenes.hpp"

using namespace first_contact;

namespace general_sphere_chapter {

//! [plain_kind]
EdgeKind plain_kind(const Vector& n, const Vector& m, const Vector& along) {
  const double turn = dot(n.cross(m), along);
  return turn > 0 ? EdgeKind::convex : turn < 0 ? EdgeKind::concave : EdgeKind::flat;
}
//! [plain_kind]

//! [plain_buried]
bool plain_buried(const std::vector<Vector>& edges) {
  Vector middle = Vector::Zero();
  for (const Vector& e : edges)
    for (const Vector& f : edges) {
      const Vector rim = e.cross(f);
      if (std::all_of(edges.begin(), edges.end(), [&](const Vector& g) { return dot(rim, g) <= 0; }))
        middle += rim;
    }
  return !std::all_of(edges.begin(), edges.end(), [&](const Vector& g) { return dot(middle, g) < 0; });
}
//! [plain_buried]

namespace {

Mesh turned(const Mesh& mesh, const Rigid& turn) {
  std::vector<Point> vertices;
  for (const Point& p : mesh.vertices()) vertices.push_back(turn.point(p));
  return {vertices, mesh.faces()};
}

// The edges at a vertex, as unit vectors away from it.
std::vector<Vector> edges_from(const Mesh& mesh, const MeshEdges& topology, std::uint32_t vertex) {
  std::vector<Vector> edges;
  for (const std::uint32_t number : topology.edges_at(vertex)) {
    const auto [p, q] = topology.edges()[number].vertices;
    edges.push_back(normalized(mesh.vertices()[p == vertex ? q : p] - mesh.vertices()[vertex]));
  }
  return edges;
}

void count(const Mesh& mesh, TurnedSolids& solids) {
  const MeshEdges topology(mesh);
  for (const MeshEdges::Edge& edge : topology.edges()) {
    if (edge.kind != EdgeKind::flat) continue;
    const Facet one(mesh.triangle(topology.sides(edge)[0].face)),
        other(mesh.triangle(topology.sides(edge)[1].face));
    const Vector along = mesh.vertices()[edge.vertices[1]] - mesh.vertices()[edge.vertices[0]];
    ++solids.seams;
    solids.seams_felt += plain_kind(one.normal, other.normal, along) != EdgeKind::flat;
  }
  for (std::uint32_t i = 0; i < mesh.vertices().size(); ++i) {
    ++solids.corners;
    solids.corners_buried += plain_buried(edges_from(mesh, topology, i));
  }
}

}  // namespace

TurnedSolids turned_solids(int times) {
  std::mt19937 random(5);
  TurnedSolids solids;
  for (int i = 0; i < times; ++i) {
    const Vector axis = program::unit_vector(random);
    count(turned(cut_cube(), Rigid::turned(axis, 3 * program::uniform(random))), solids);
  }
  return solids;
}

}  // namespace general_sphere_chapter
