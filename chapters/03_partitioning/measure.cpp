#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "first_contact/trees/objects.hpp"

using namespace first_contact;

namespace {

bool same(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->time == b->time && a->points == b->points && a->normal == b->normal && a->feature == b->feature &&
         a->triangle == b->triangle;
}

std::vector<std::uint32_t> children_of(const Octree::Node& node) {
  std::vector<std::uint32_t> children(8);
  std::iota(children.begin(), children.end(), node.first_child);
  return children;
}
std::vector<std::uint32_t> children_of(const BspTree::Node& node) { return {node.front, node.back}; }
std::vector<std::uint32_t> children_of(const BoxTree::Node& node) {
  return {node.first_child, node.first_child + 1};
}

// Does a divided node keep objects for itself? Those of a BSP tree do, what lies in their plane.
template <class Tree>
constexpr bool keeps_objects = std::is_same_v<Tree, BspTree>;

// The sum of the depths of all objects at or below a node.
template <class Tree>
std::size_t depths_below(const Tree& tree, std::size_t number, std::size_t depth) {
  const typename Tree::Node& node = tree.node(number);
  std::size_t sum = node.is_leaf() || keeps_objects<Tree> ? depth * (node.end - node.begin) : 0;
  if (node.is_leaf()) return sum;
  for (const std::uint32_t child : children_of(node)) sum += depths_below(tree, child, depth + 1);
  return sum;
}

template <class Tree>
Depth depth_in(const Tree& tree) {
  const double count = std::max<double>(1, static_cast<double>(tree.order().size()));
  return {static_cast<double>(depths_below(tree, 0, 0)) / count, tree.depth()};
}

}  // namespace

bool same_contacts(const Cost& a, const Cost& b) {
  return std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(), same);
}

Depth depth_of_objects(const Octree& tree) { return depth_in(tree); }
Depth depth_of_objects(const BspTree& tree) { return depth_in(tree); }
Depth depth_of_objects(const BoxTree& tree) { return depth_in(tree); }

double log8(std::size_t k) { return k < 1 ? 0 : std::log2(static_cast<double>(k)) / 3; }

//! [overlapping_pairs]
Pairs overlapping_pairs(const std::vector<Bounds>& boxes) {
  const Objects<Octree> objects(boxes);
  const Octree& tree = objects.tree();
  Pairs count{pairs(objects).size(), 0};
  for (std::size_t number = 0; number < tree.nodes(); ++number) {
    const Octree::Node& leaf = tree.node(number);
    if (!leaf.is_leaf()) continue;
    for (std::uint32_t i = leaf.begin; i < leaf.end; ++i)
      for (std::uint32_t j = leaf.begin; j < i; ++j)
        count.in_one_leaf += overlap(boxes[tree.order()[i]], boxes[tree.order()[j]]);
  }
  return count;
}
//! [overlapping_pairs]
