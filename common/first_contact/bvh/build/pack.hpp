#pragma once
#include <cstdint>
#include <vector>

#include "first_contact/bvh/build/large_pages.hpp"
#include "first_contact/bvh/build/layout.hpp"
#include "first_contact/bvh/build/split.hpp"
#include "first_contact/bvh/build/surface.hpp"

namespace first_contact::bvh {

/// A leaf's sixteen possible coordinates are read as two whole vectors, wherever it ends: so many units are
/// left behind the last.
inline constexpr std::size_t read_past_the_end = 64 / leaf_unit;

/// The wide tree and the memory that it lies in.
struct PackedTree {
  LargeVector<Node> nodes;
  LargeVector<LeafUnit> leaves;
  Ref root = leaf_bit;
  float leaf_size = 0;  ///< the mean of the longest side of the leaves' boxes

  /// Calls visit(leaf) for all leaves, as they lie in memory.
  template <class Visit>
  void each_leaf(const Visit& visit) const {
    const std::size_t end = leaves.empty() ? 0 : leaves.size() - read_past_the_end;
    for (std::uint32_t at = 0; at < end; at += units_of(leaf_at(leaves.data(), at))) visit(leaf_bit | at);
  }
};

/// Writes the binary tree as a wide one:
/// \see layout.hpp for the form, collapse.hpp for the choice.
///
/// The idea: every rounding goes outward. A box is stored in 256 steps of its parent's, a slab in 65,536; low
/// sides are rounded down and high sides up, so that what is stored holds what it stands for.
PackedTree pack(const BinaryTree& tree, const Surface& surface, const Space& space);

}  // namespace first_contact::bvh
