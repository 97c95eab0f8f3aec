#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "first_contact/trees/search.hpp"
#include "first_contact/trees/tree.hpp"

namespace first_contact {

/// When a tree of boxes stops dividing.
struct BoxTreeLimits {
  std::size_t capacity = 4;  ///< a node with no more objects than this is a leaf
};

/// The box around some objects: divided in two, or a leaf.
struct BoxTreeNode {
  Bounds bounds;                  ///< of its objects
  std::uint32_t first_child = 0;  ///< the number of the first of two; 0 for a leaf
  ///@{
  /// Its objects: places in `order()`.
  std::uint32_t begin = 0, end = 0;
  ///@}

  /// Is it not divided?
  bool is_leaf() const { return first_child == 0; }
};

/// A tree of boxes over objects that are known by their bounds (bounding volume hierarchy, BVH): the box
/// around all, and the boxes around two parts of them, and so on. Each object is in one leaf only; boxes may
/// overlap, but none is larger than what it holds.
///
/// Where to cut is told by the surface area heuristic (Goldsmith and Salmon 1987), looked for among 15 cuts
/// along each axis (Wald 2007).
class BoxTree : public NodeTree<BoxTreeNode> {
 public:
  /// Of objects, by their bounds.
  explicit BoxTree(std::span<const Bounds> objects, const BoxTreeLimits& limits = {});
  /// Of polygons, by their bounds.
  explicit BoxTree(std::span<const Triangle> polygons, const BoxTreeLimits& limits = {});

  /// Shows a search all nodes that it reaches, and tests the objects of their leaves. Of two children the one
  /// from which the motion comes is shown first.
  void search(Search& search) const;

 private:
  void divide(std::size_t node, std::span<const Bounds> objects, const BoxTreeLimits& limits,
              std::size_t depth);
  std::uint32_t cut(const Node& parent, std::span<const Bounds> objects);
  void show(std::size_t node, Search& search, std::size_t depth) const;
};

static_assert(Partition<BoxTree>);

}  // namespace first_contact
