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
  explicit Environment(Mesh surface) : mesh_(std::move(surface)), edges_(mesh_) {
    facets_.reserve(mesh_.size());
    for (std::size_t i = 0; i < mesh_.size(); ++i) facets_.emplace_back(mesh_.triangle(i));
  }

  const Mesh& mesh() const { return mesh_; }
  const MeshEdges& topology() const { return edges_; }
  const Facet& facet(std::size_t face) const { return facets_[face]; }

 private:
  Mesh mesh_;
  MeshEdges edges_;
  std::vector<Facet> facets_;
};

}  // namespace first_contact
