#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "first_contact/trees/search.hpp"
#include "first_contact/trees/tree.hpp"

namespace first_contact {

/// When an octree stops dividing.
struct OctreeLimits {
  std::size_t capacity = 8;  ///< a node with no more objects than this is a leaf
  std::size_t depth = 20;    ///< a node this deep is a leaf; the root's depth is 0
};

/// A cube: divided into eight, or a leaf.
struct OctreeNode {
  Bounds bounds;                  ///< of its objects; empty if it has none
  Point low;                      ///< the lowest corner of its cube
  double side;                    ///< the length of the cube's edges
  std::uint32_t first_child = 0;  ///< the number of the first of eight; 0 for a leaf
  ///@{
  /// Its objects: places in `order()`.
  std::uint32_t begin = 0, end = 0;
  ///@}

  /// Is it not divided?
  bool is_leaf() const { return first_child == 0; }
};

/// An octree over objects that are known by their bounds (paper, 1.4): a cube, cut into eight equal ones, and
/// those again. Each node has eight children or none.
///
/// Each object belongs to one leaf only, the one in whose cube its centre lies; how far the objects of a node
/// reach beyond its cube is known from their common bounds, kept with the node. This is a *loose* octree,
/// whose looseness is not a fixed factor but as small as the objects allow. The other way, to refer to an
/// object from every leaf that it overlaps, keeps the cubes disjoint, but finds an object several times, and
/// a large one among many small ones is noted in nearly every leaf.
class Octree : public NodeTree<OctreeNode> {
 public:
  /// Of objects, by their bounds.
  explicit Octree(std::span<const Bounds> objects, const OctreeLimits& limits = {});
  /// Of polygons, by their bounds.
  explicit Octree(std::span<const Triangle> polygons, const OctreeLimits& limits = {});

  /// Shows a search all nodes that it reaches, and tests the objects of their leaves. The child from which
  /// the motion comes is shown first.
  void search(Search& search) const;

 private:
  void divide(std::size_t node, std::span<const Bounds> objects, const OctreeLimits& limits,
              std::size_t depth);
  void distribute(const Node& parent, std::span<const Bounds> objects);
  void show(std::size_t node, Search& search, unsigned nearest, std::size_t depth) const;
};

static_assert(Partition<Octree>);

}  // namespace first_contact
