#pragma once
#include <cstdint>
#include <vector>

#include "first_contact/bvh/build/space.hpp"
#include "first_contact/bvh/build/surface.hpp"

namespace first_contact::bvh {

/// Three floats and one to spare: one register on any machine with vectors, four floats on others.
using Floats4 __attribute__((vector_size(16))) = float;

/// A node of the binary tree, from which the wide one is made.
struct Branch {
  Floats4 low, high;           ///< its box, in the tree's unit, to the rounding of a float
  std::uint32_t first, count;  ///< its triangles have these places in the order of the tree
  std::uint32_t children;      ///< they are children and children + 1; 0 for a leaf
  bool leaf() const { return children == 0; }
};

/// The binary tree, the root first, each child after its parent.
struct BinaryTree {
  std::vector<Branch> branches;
  std::vector<std::uint32_t> order;  ///< the numbers of the triangles, those of a leaf together
};

/// Cuts the mesh in two, and the parts again, until no part has more than 8 triangles and 16 vertices.
///
/// By the surface area heuristic (trees/bin_cut.hpp) with 16 bins along each axis, or 8 for a few triangles, and
/// work counted in leaves of eight. It equals the cuts of the plain tree, which always has 16 bins and counts
/// single triangles.
BinaryTree split(const Surface& surface, const Space& space);

}  // namespace first_contact::bvh
