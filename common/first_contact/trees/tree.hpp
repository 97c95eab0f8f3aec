#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "first_contact/geometry/bounds.hpp"

namespace first_contact {

/// What all trees consist of: nodes, the root first, and the numbers of their objects, those of each node
/// side by side, so that a node needs but two places in `order()`.
template <class NodeOfTree>
class NodeTree {
 public:
  /// A part of space, or a part of the objects.
  using Node = NodeOfTree;

  /// How many nodes there are.
  std::size_t nodes() const { return nodes_.size(); }
  /// The depth of the deepest; the root's is 0.
  std::size_t depth() const { return depth_; }
  /// How many times an object, or a piece of one, was looked at to build the tree.
  std::size_t work() const { return work_; }
  /// The root has number 0.
  const Node& node(std::size_t i) const { return nodes_[i]; }
  /// The objects' numbers; one that was cut is there more than once.
  const std::vector<std::uint32_t>& order() const { return order_; }

 protected:
  /// An empty one.
  NodeTree() = default;
  /// With its objects in that order.
  explicit NodeTree(std::vector<std::uint32_t> order) : order_(std::move(order)) {}

  std::vector<Node> nodes_;           ///< the root first
  std::vector<std::uint32_t> order_;  ///< the objects' numbers
  std::size_t depth_ = 0;             ///< of the deepest node
  std::size_t work_ = 0;              ///< objects looked at
};

/// 0, 1, ..., count - 1: all objects, before a tree has put them in its order.
std::vector<std::uint32_t> all_in_order(std::size_t count);

/// The bounds of each polygon.
std::vector<Bounds> bounds_of_each(std::span<const Triangle> polygons);

}  // namespace first_contact
