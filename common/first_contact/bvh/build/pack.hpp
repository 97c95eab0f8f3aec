#pragma once
#include <cstdint>
#include <vector>

#include "first_contact/bvh/build/layout.hpp"
#include "first_contact/bvh/build/split.hpp"
#include "first_contact/bvh/build/surface.hpp"

namespace first_contact::bvh {

/// The wide tree and the memory that it lies in.
struct PackedTree {
  std::vector<Node> nodes;
  std::vector<LeafUnit> leaves;
  Ref root = leaf_bit;
  float leaf_size = 0;  ///< the mean of the longest side of the leaves' boxes
};

/// Writes the binary tree as a wide one:
/// \see layout.hpp for the form, collapse.hpp for the choice.
///
/// The idea: every rounding goes outward. A box is stored in 256 steps of its parent's, a slab in 65,536; low
/// sides are rounded down and high sides up, so that what is stored holds what it stands for.
PackedTree pack(const BinaryTree& tree, const Surface& surface, const Space& space);

}  // namespace first_contact::bvh
