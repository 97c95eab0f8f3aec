#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "first_contact/trees/search.hpp"
#include "first_contact/trees/tree.hpp"

namespace first_contact {

/// When a BSP tree stops dividing.
struct BspLimits {
  std::size_t capacity = 4;     ///< a node with no more polygons than this is a leaf
  std::size_t depth = 64;       ///< a node this deep is a leaf; the root's depth is 0. At most 64
  std::size_t candidates = 16;  ///< of so many polygons the one whose plane divides best is taken
  std::size_t growth = 8;       ///< there may be this many pieces to a polygon on the average
};

/// A part of space: cut by a plane, or a leaf.
struct BspNode {
  std::optional<Plane> plane;  ///< none: a leaf
  ///@{
  /// The number of a child.
  std::uint32_t front = 0, back = 0;
  ///@}
  ///@{
  /// Its polygons, within the plane, or all of a leaf: places in `order()`.
  std::uint32_t begin = 0, end = 0;
  ///@}

  /// Is it not cut any more?
  bool is_leaf() const { return !plane; }
};

/// A BSP tree over polygons (paper, 1.4): the plane of one polygon divides space and the other polygons into
/// what is in front of it and what is behind; then each half is divided likewise. Polygons within the plane
/// stay at the node.
///
/// A polygon on both sides is cut in two, but only to find out where it belongs: the tree keeps the polygon's
/// number on both sides, and what is tested in the end is the polygon as it was given. So there are no new
/// vertices, whose rounding would open cracks, and no touch of an edge that is but a cut.
class BspTree : public NodeTree<BspNode> {
 public:
  /// Cuts space by the planes of the polygons until few are left in each part.
  explicit BspTree(std::span<const Triangle> polygons, const BspLimits& limits = {});

  /// Shows a search all parts of space that it reaches, those first to which the motion comes first, and
  /// tests the polygons there.
  void search(Search& search) const;

  /// A polygon counts as within a plane if it is no further from it than this, in units of the largest
  /// coordinate: about ten times what rounding makes of a square of many triangles.
  static constexpr double thickness = 0x1p-44;  // 256 eps

 private:
  class Builder;
  using Shown = std::unordered_set<std::uint32_t>;
  void show(std::size_t node, Search& search, const Passage& part, Shown& shown, std::size_t depth) const;
  void test(const Node& node, Search& search, Shown& shown) const;
};

static_assert(Partition<BspTree>);

}  // namespace first_contact
