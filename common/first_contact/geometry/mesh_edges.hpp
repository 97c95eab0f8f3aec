#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "first_contact/geometry/facet.hpp"
#include "first_contact/geometry/mesh.hpp"

namespace first_contact {

/// How the surface bends at an edge, seen from the side to which the normal of its first face points.
enum class EdgeKind {
  convex,       ///< a ridge
  concave,      ///< a valley; from the other side of the surface, a ridge
  flat,         ///< no bend: the two faces lie in one plane
  boundary,     ///< the surface ends here
  non_manifold  ///< three faces or more meet here
};

/// The edges of a mesh, what they join, and how the surface bends there.
///
/// Vertices at the very same position are one vertex here, whatever their numbers: files that repeat the
/// corners of each triangle (STL, some OBJ) have edges all the same. Such a vertex goes by its lowest number.
class MeshEdges {
 public:
  /// One face at an edge: the side of that face from its corner `slot` to the next.
  struct Side {
    /// The number of the face.
    std::uint32_t face;
    /// 0, 1 or 2: the corner at which the side begins.
    std::uint32_t slot;
  };
  /// An edge of length greater than 0; from the vertex that is first in the order of x, then y, then z.
  struct Edge {
    /// The numbers of its two ends.
    std::array<std::uint32_t, 2> vertices;
    /// How the surface bends there.
    EdgeKind kind;
    ///@{
    /// Where its sides are kept, and how many.
    std::uint32_t first_side, side_count;
    ///@}
  };

  /// The normals of two faces in one plane differ by no more than their own rounding, which is at most this
  /// times l / h for a triangle with longest side l and height h: the cross product of two sides is wrong by
  /// less than 8 eps of the product of their lengths, and this is twice as much.
  /// \see tests/unit/mesh_edges.cpp
  static constexpr double flat_tolerance = 16 * std::numeric_limits<double>::epsilon();

  /// Finds all edges, in O(n log n).
  explicit MeshEdges(const Mesh& mesh);

  /// All of them.
  const std::vector<Edge>& edges() const { return edges_; }
  /// The faces at an edge, lowest number first.
  std::span<const Side> sides(const Edge& edge) const { return {&sides_[edge.first_side], edge.side_count}; }
  /// The lowest number of a vertex at the position of this one.
  std::uint32_t representative(std::uint32_t vertex) const { return representative_[vertex]; }
  /// The numbers of the edges at a vertex, which goes by its lowest number; none if it has another.
  std::span<const std::uint32_t> edges_at(std::uint32_t vertex) const { return edges_at_.of(vertex); }
  /// The numbers of the faces at a vertex, lowest first.
  std::span<const std::uint32_t> faces_at(std::uint32_t vertex) const { return faces_at_.of(vertex); }
  /// Is a vertex never the first thing that a sphere touches (paper, figure 9)? It is so if no direction
  /// leads away from all its edges: whatever touches the vertex then touches one of the edges, or a face, as
  /// well. When in doubt the answer is no. A vertex without edges is buried.
  bool buried(std::uint32_t vertex) const { return buried_[vertex]; }

 private:
  /// For each of some things the numbers of some other things, in one array.
  struct Lists {
    std::vector<std::uint32_t> first, items;
    std::span<const std::uint32_t> of(std::uint32_t i) const {
      return std::span<const std::uint32_t>(items).subspan(first[i], first[i + 1] - first[i]);
    }
  };

  void collect_edges(const Mesh& mesh);
  void collect_surroundings(const Mesh& mesh);

  std::vector<std::uint32_t> representative_;
  std::vector<Side> sides_;
  std::vector<Edge> edges_;
  Lists edges_at_, faces_at_;
  std::vector<bool> buried_;
};

/// Does a point come before another in the order of x, then y, then z?
bool comes_before(const Point& p, const Point& q);

/// How two faces meet along the first one's side, which goes `along`. `opposed` says that they go along the
/// edge in opposite directions, as faces do whose normals point to the same side of the surface.
EdgeKind kind_of(const Facet& first, const Facet& second, const Vector& along, bool opposed);

/// Is a vertex with these edges (vectors away from it, of unit length) buried?
/// \see MeshEdges::buried
bool buried_by(const std::vector<Vector>& edges);

}  // namespace first_contact
