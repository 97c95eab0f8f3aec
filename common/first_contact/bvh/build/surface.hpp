#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "first_contact/bvh/build/lists.hpp"
#include "first_contact/geometry/mesh.hpp"

namespace first_contact::bvh {

/// A mesh whose vertices at the same position are one, and which triangles meet at each: what is asked while
/// a tree is built, and not kept.
///
/// It equals MeshEdges::representative and MeshEdges::faces_at.
class Surface {
 public:
  /// The mesh must outlive it.
  explicit Surface(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  /// A triangle's corners, each by the lowest number of a vertex at its position.
  const Mesh::Face& corners(std::uint32_t triangle) const { return corners_[triangle]; }
  const Point& position(std::uint32_t vertex) const { return mesh_.vertices()[vertex]; }
  /// The triangles at a vertex that goes by its lowest number; the lowest first.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const { return around_.of(vertex); }

 private:
  const Mesh& mesh_;
  std::vector<Mesh::Face> corners_;
  Lists around_;
};

}  // namespace first_contact::bvh
