#pragma once
#include <cstddef>
#include <limits>

#include "first_contact/geometry/mesh.hpp"

namespace first_contact {

/// What is wrong with a mesh. None of it keeps a sweep from being right; but it tells of a fault in the
/// program that made the mesh.
struct MeshDefects {
  std::size_t degenerate = 0;    ///< triangles without an area
  std::size_t duplicate = 0;     ///< triangles that have the very corners of one before them, in any order
  std::size_t non_manifold = 0;  ///< edges of three triangles or more, the ones above not counted

  /// Is nothing wrong?
  bool none() const { return degenerate + duplicate + non_manifold == 0; }
};

/// A triangle has no area if its cross product is no longer than its own rounding, which is below 8 eps times
/// the product of the two sides.
/// \see MeshEdges::flat_tolerance
inline constexpr double degenerate_tolerance = 8 * std::numeric_limits<double>::epsilon();

/// Counts what is wrong with a mesh, in O(n log n). Vertices at the very same position are one vertex,
/// whatever their numbers. Nothing is refused.
MeshDefects diagnose(const Mesh& mesh);

}  // namespace first_contact
