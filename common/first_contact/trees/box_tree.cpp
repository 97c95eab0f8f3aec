#include "first_contact/trees/box_tree.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/trees/bin_cut.hpp"

namespace first_contact {

namespace {

constexpr std::size_t bin_count = 16;
constexpr double infinite = std::numeric_limits<double>::infinity();
// From this depth on parts are halved by number, so that no arrangement of objects makes the tree much
// deeper.
constexpr std::size_t deepest_by_surface = 64;

// What a part is expected to cost: half its surface times its number of objects. The unit of length is that of
// the node, in which no surface leaves the range of double.
struct Part {
  Bounds bounds;
  std::size_t count = 0;
  double unit = 1;

  void add(const Part& other) {
    bounds.extend(other.bounds);
    count += other.count;
    unit = other.unit;
  }
  double work() const {
    if (count == 0) return 0;
    const Vector d = unit * bounds.sizes();
    return (d.x() * d.y() + d.y() * d.z() + d.z() * d.x()) * static_cast<double>(count);
  }
};

std::size_t bin_of(const Bounds& object, const Bounds& centers, int axis) {
  const double part = (middle_of(object)[axis] - centers.min()[axis]) / centers.sizes()[axis];
  return std::min(static_cast<std::size_t>(part * bin_count), bin_count - 1);
}

}  // namespace

BoxTree::BoxTree(std::span<const Triangle> polygons, const BoxTreeLimits& limits)
    : BoxTree(bounds_of_each(polygons), limits) {}

BoxTree::BoxTree(std::span<const Bounds> objects, const BoxTreeLimits& limits)
    : NodeTree(all_in_order(objects.size())) {
  nodes_.push_back({bounds_of(objects), 0, 0, static_cast<std::uint32_t>(objects.size())});
  divide(0, objects, limits, 0);
}

//! [divide_boxes]
void BoxTree::divide(std::size_t node, std::span<const Bounds> objects, const BoxTreeLimits& limits,
                     std::size_t depth) {
  depth_ = std::max(depth_, depth);
  const Node parent = nodes_[node];
  const std::uint32_t count = parent.end - parent.begin;
  if (count <= std::max<std::size_t>(1, limits.capacity)) return;

  const std::uint32_t middle = depth < deepest_by_surface ? cut(parent, objects) : parent.begin + count / 2;
  const std::size_t child = nodes_.size();
  nodes_[node].first_child = static_cast<std::uint32_t>(child);
  for (const auto& [begin, end] : {std::pair(parent.begin, middle), std::pair(middle, parent.end)}) {
    nodes_.push_back({{}, 0, begin, end});
    for (std::uint32_t i = begin; i < end; ++i) nodes_.back().bounds.extend(objects[order_[i]]);
  }
  work_ += count;
  divide(child, objects, limits, depth + 1);
  divide(child + 1, objects, limits, depth + 1);
}
//! [divide_boxes]

// Orders the objects of a node by the best cut; gives the place where the second part begins.
std::uint32_t BoxTree::cut(const Node& parent, std::span<const Bounds> objects) {
  const auto begin = order_.begin() + parent.begin, end = order_.begin() + parent.end;
  Bounds centers;
  std::for_each(begin, end, [&](std::uint32_t i) { centers.extend(middle_of(objects[i])); });
  const double unit = unit_scale(largest(parent.bounds.sizes()));
  BinCut<double> best;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = centers.sizes()[axis];
    if (!(extent > 0 && extent < infinite)) continue;
    std::array<Part, bin_count> bins;
    bins.fill({{}, 0, unit});
    std::for_each(begin, end, [&](std::uint32_t i) {
      bins[bin_of(objects[i], centers, axis)].add({objects[i], 1, unit});
    });
    improve<bin_count>(best, std::span<const Part>(bins), axis);
    work_ += parent.end - parent.begin;
  }
  if (best.axis < 0) return parent.begin + (parent.end - parent.begin) / 2;  // all in one place
  const auto above = std::stable_partition(
      begin, end, [&](std::uint32_t i) { return bin_of(objects[i], centers, best.axis) <= best.bin; });
  return static_cast<std::uint32_t>(above - order_.begin());
}

void BoxTree::search(Search& search) const { show(0, search, 0); }

//! [show_boxes]
void BoxTree::show(std::size_t node, Search& search, std::size_t depth) const {
  search.count_node(depth);
  const Node& here = nodes_[node];
  if (here.bounds.isEmpty() || !search.reaches(here.bounds)) return;
  if (here.is_leaf()) {
    for (std::uint32_t i = here.begin; i < here.end; ++i) search.test(order_[i]);
    return;
  }
  const std::size_t a = here.first_child, b = a + 1;
  const Vector from_a_to_b = middle_of(nodes_[b].bounds) - middle_of(nodes_[a].bounds);
  const bool a_first = dot(search.heading(), from_a_to_b) >= 0;
  show(a_first ? a : b, search, depth + 1);
  show(a_first ? b : a, search, depth + 1);
}
//! [show_boxes]

}  // namespace first_contact
