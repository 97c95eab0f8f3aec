#include "first_contact/bvh/plain_bvh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "first_contact/bvh/cast/verdict.hpp"

namespace first_contact {

namespace {

constexpr std::uint32_t most_in_a_leaf = 4;
constexpr std::size_t bins = 16;
constexpr double infinite = std::numeric_limits<double>::infinity();
/// What the tests of triangles and of boxes round, in terms of all lengths in play:
/// \see rounding_of_distance
constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();

}  // namespace

void PlainBvh::Box::add(const Box& other) {
  low = low.cwiseMin(other.low);
  high = high.cwiseMax(other.high);
}

double PlainBvh::Box::surface() const {
  const Vector d = high - low;
  return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

PlainBvh::PlainBvh(Mesh mesh) : mesh_(std::move(mesh)), order_(mesh_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (mesh_.size() > 0) plant();
  surface_.emplace(mesh_, bvh::Merged(mesh_), order_);
}

void PlainBvh::plant() {
  std::vector<Box> boxes(mesh_.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Triangle t = mesh_.triangle(i);
    boxes[i].low = t.a.cwiseMin(t.b).cwiseMin(t.c);
    boxes[i].high = t.a.cwiseMax(t.b).cwiseMax(t.c);
  }
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(mesh_.size()), 0});
  grow(boxes, 0);
}

void PlainBvh::grow(std::vector<Box>& boxes, std::uint32_t number) {
  Node& node = nodes_[number];
  for (std::uint32_t i = 0; i < node.count; ++i) node.box.add(boxes[order_[node.first + i]]);
  if (node.count <= most_in_a_leaf) return;
  const std::uint32_t below = cut(boxes, node);
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  node.children = children;
  const Node left{{}, node.first, below, 0}, right{{}, node.first + below, node.count - below, 0};
  nodes_.push_back(left);
  nodes_.push_back(right);
  grow(boxes, children);
  grow(boxes, children + 1);
}

//! [cut_plain_bvh]
/// Between which bins of an axis a node is cut, and the work to expect then.
struct PlainBvh::Cut {
  double cost = infinite;
  Eigen::Index axis = 0;
  std::size_t bin = 0;
};

/// What lies in each of the bins along an axis.
struct PlainBvh::Bins {
  std::array<Box, bins> box;
  std::array<double, bins> count{};

  void add(std::size_t bin, const Box& more) {
    box[bin].add(more);
    ++count[bin];
  }

  /// Is there a better cut along this axis? Costs from above first, then, from below, the sums.
  void improve(Cut& best, Eigen::Index axis) const {
    std::array<double, bins> cost_above{};
    const auto scan = [&](Box& sum, double& n, std::size_t bin) {
      sum.add(box[bin]);
      n += count[bin];
      return n > 0 ? n * sum.surface() : infinite;
    };
    Box above, below;
    double n_above = 0, n_below = 0;
    for (std::size_t i = bins - 1; i > 0; --i) cost_above[i] = scan(above, n_above, i);
    for (std::size_t i = 0; i + 1 < bins; ++i) {
      const double cost = scan(below, n_below, i) + cost_above[i + 1];
      if (cost < best.cost) best = {cost, axis, i};
    }
  }
};

/// Orders the triangles of a node so that the first ones, whose number it gives, are on one side of the best
/// of 15 cuts along each axis. The chance that a path through the node meets a part of it is about the ratio
/// of their surfaces; so surface times number of triangles, of both sides, is the work to expect (the surface
/// area heuristic).
std::uint32_t PlainBvh::cut(const std::vector<Box>& boxes, const Node& node) {
  const auto begin = order_.begin() + node.first, end = begin + node.count;
  const auto middle = [&](std::uint32_t triangle) {
    return Point(boxes[triangle].low / 2 + boxes[triangle].high / 2);
  };
  Box middles;
  for (auto i = begin; i != end; ++i) middles.add({middle(*i), middle(*i)});
  const Vector extent = middles.high - middles.low;
  const auto bin_of = [&](std::uint32_t triangle, Eigen::Index axis) {
    const double part = (middle(triangle)[axis] - middles.low[axis]) / extent[axis];
    return std::min(static_cast<std::size_t>(part * bins), bins - 1);
  };

  Cut best;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (!(extent[axis] > 0)) continue;
    Bins filled;
    for (auto i = begin; i != end; ++i) filled.add(bin_of(*i, axis), boxes[*i]);
    filled.improve(best, axis);
  }
  if (best.cost == infinite) return node.count / 2;  // all in one place
  const auto above =
      std::partition(begin, end, [&](std::uint32_t i) { return bin_of(i, best.axis) <= best.bin; });
  return static_cast<std::uint32_t>(above - begin);
}
//! [cut_plain_bvh]

int PlainBvh::depth(const Node& node) const {
  if (node.children == 0) return 1;
  return 1 + std::max(depth(nodes_[node.children]), depth(nodes_[node.children + 1]));
}

int PlainBvh::depth() const { return nodes_.empty() ? 0 : depth(nodes_[0]); }

PlainBvh::Path::Path(const Moving<Sphere>& moving)
    : start(moving.shape.center), inverse(moving.displacement.cwiseInverse()), radius(moving.shape.radius) {
  radius += rounding * (start.cwiseAbs().maxCoeff() + moving.displacement.cwiseAbs().maxCoeff() + radius);
}

//! [entry_plain_bvh]
/// When the centre enters the box grown by the radius, in [0, latest]; infinite if it does not (the slab test
/// of Kay and Kajiya). Grown again by what is rounded; an axis along which nothing moves gives infinite times
/// of the right signs, or 0 times infinity if the start is just on the border, which excludes nothing.
double PlainBvh::Path::entry(const Box& box, double latest) const {
  double enter = 0, leave = latest;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double grown = radius + rounding * std::max(std::abs(box.low[i]), std::abs(box.high[i]));
    const double low = (box.low[i] - grown - start[i]) * inverse[i],
                 high = (box.high[i] + grown - start[i]) * inverse[i];
    const double first = inverse[i] < 0 ? high : low, last = inverse[i] < 0 ? low : high;
    if (first > enter) enter = first;
    if (last < leave) leave = last;
  }
  return enter <= leave ? enter : infinite;
}
//! [entry_plain_bvh]

std::optional<Contact> sweep(const Moving<Sphere>& moving, const PlainBvh& tree) {
  if (moving.displacement.isZero(0)) return std::nullopt;
  bvh::Verdict verdict(tree.surface(), moving);
  tree.visit(moving, [&](std::uint32_t place) {
    verdict.consider(tree.surface().places()[place]);
    return verdict.latest();
  });
  return verdict.contact();
}

}  // namespace first_contact
