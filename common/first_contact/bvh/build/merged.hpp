#pragma once
#include <cstdint>
#include <vector>

#include "first_contact/geometry/mesh.hpp"

namespace first_contact::bvh {

/// Which vertices of a mesh are in the same position, so that they are one. It equals
/// MeshEdges::representative.
class Merged {
 public:
  explicit Merged(const Mesh& mesh);

  /// The lowest number of a vertex at the very position of this one.
  std::uint32_t representative(std::uint32_t vertex) const {
    return representative_.empty() ? vertex : representative_[vertex];
  }
  /// A face's corners, each by its representative.
  Mesh::Face corners(const Mesh::Face& face) const {
    return {representative(face[0]), representative(face[1]), representative(face[2])};
  }

 private:
  std::vector<std::uint32_t> representative_;  // empty if no two vertices are in the same position
};

}  // namespace first_contact::bvh
