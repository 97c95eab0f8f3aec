#include "measure.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/partition/objects.hpp"

using namespace first_contact;

namespace {

bool same(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->time == b->time && a->points == b->points && a->normal == b->normal && a->feature == b->feature &&
         a->triangle == b->triangle;
}

// The sum of the depths of all objects at or below a node.
std::size_t depths_below(const Octree& tree, std::size_t number, std::size_t depth) {
  const Octree::Node& node = tree.node(number);
  if (node.is_leaf()) return depth * (node.end - node.begin);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < 8; ++i) sum += depths_below(tree, node.first_child + i, depth + 1);
  return sum;
}

}  // namespace

bool same_contacts(const Cost& a, const Cost& b) {
  return std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(), same);
}

Depth depth_of_objects(const Octree& tree) {
  const double count = std::max<double>(1, static_cast<double>(tree.order().size()));
  return {static_cast<double>(depths_below(tree, 0, 0)) / count, tree.depth()};
}

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
