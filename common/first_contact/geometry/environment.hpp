#pragma once
#include <vector>

#include "first_contact/geometry/facet.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/mesh_edges.hpp"

namespace first_contact {

/// An arbitrary environment (paper, 2.1): a mesh with all that many sweeps against it need to know only once,
/// the planes of its faces and the topology of its edges. Both sides of its faces are solid.
class Environment {
 public:
  /// Finds the planes and the edges of the mesh.
  explicit Environment(Mesh surface) : mesh_(std::move(surface)), edges_(mesh_) {
    facets_.reserve(mesh_.size());
    for (std::size_t i = 0; i < mesh_.size(); ++i) facets_.emplace_back(mesh_.triangle(i));
  }

  /// The surface.
  const Mesh& mesh() const { return mesh_; }
  /// Its edges, and the faces that share them.
  const MeshEdges& topology() const { return edges_; }
  /// The face with that number.
  const Facet& facet(std::size_t face) const { return facets_[face]; }

 private:
  Mesh mesh_;
  MeshEdges edges_;
  std::vector<Facet> facets_;
};

}  // namespace first_contact
