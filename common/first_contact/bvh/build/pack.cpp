#include "first_contact/bvh/build/pack.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "first_contact/bvh/build/collapse.hpp"
#include "first_contact/bvh/build/cones.hpp"
#include "first_contact/bvh/build/parallel.hpp"

namespace first_contact::bvh {

namespace {

/// The slabs of larger parts of a mesh are as thick as their boxes.
constexpr std::uint32_t most_in_a_slab = 64;
/// A unit smaller than this is not needed: the error of a position in the tree's unit is larger.
constexpr int smallest_exponent = -100;

/// The different vertices of a leaf, and which of them the corners of its triangles are.
struct LeafVertices {
  std::array<std::uint32_t, most_vertices> number;
  std::size_t count = 0;

  std::uint32_t place_of(std::uint32_t vertex) {
    const auto end = number.begin() + static_cast<std::ptrdiff_t>(count);
    const auto found = std::find(number.begin(), end, vertex);
    if (found == end) number[count++] = vertex;
    return static_cast<std::uint32_t>(found - number.begin());
  }
};

class Packer {
 public:
  Packer(const BinaryTree& from, const Collapse& wide, const Surface& triangles, const Space& unit,
         const NormalCones& turned)
      : tree_(from), collapse_(wide), surface_(triangles), space_(unit), cones_(turned) {}

  PackedTree pack();

 private:
  const Branch& branch(std::uint32_t number) const { return tree_.branches[number]; }
  std::span<const std::uint32_t> triangles(const Branch& part) const {
    return std::span(tree_.order).subspan(part.first, part.count);
  }
  Point vertex(std::uint32_t number) const { return space_.point(surface_.position(number)); }

  std::uint32_t add_leaf(const Branch& leaf);
  std::uint8_t cone(const Vector& normal, std::span<const std::uint32_t> triangles) const;
  LeafHead head_of(const Branch& leaf, LeafVertices& vertices) const;
  Node make_node(std::uint32_t number, const Cover& cover);
  Node subtree(std::uint32_t number);
  void attach(Node& parent, std::size_t j, const Node& child);
  Node append(const Packer& part, const Node& top);
  PackedTree finish();
  template <class Work>
  void in_turns(const Cover& cover, const Work& work) const;
  void write_children(Node& node, const Cover& cover);
  void write_slab(Node& node, std::size_t j, const Branch& child) const;
  Vector area_vector(std::span<const std::uint32_t> part) const;

  const BinaryTree& tree_;
  const Collapse& collapse_;
  const Surface& surface_;
  const Space& space_;
  const NormalCones& cones_;
  PackedTree result_;
  std::size_t leaf_count_ = 0;
  double sum_of_sizes_ = 0;
};

/// The cosine of the cone of some triangles about a normal, in 255ths of its length.
std::uint8_t Packer::cone(const Vector& normal, std::span<const std::uint32_t> triangles) const {
  const auto length = static_cast<float>(normal.norm());
  if (!(length > 0)) return 0;
  const Eigen::Vector3f axis = normal.cast<float>() / length;
  return static_cast<std::uint8_t>(255 * length * cones_.cosine_around(axis, triangles));
}

/// The head of a leaf but for its unit, and its vertices.
LeafHead Packer::head_of(const Branch& leaf, LeafVertices& vertices) const {
  LeafHead head{};
  head.triangles = static_cast<std::uint8_t>(leaf.count);
  const auto all = triangles(leaf);
  for (std::size_t j = 0; j < all.size(); ++j) {
    for (std::size_t i = 0; i < 3; ++i)
      head.corner[i] |= vertices.place_of(surface_.corners(all[j])[i]) << 4 * j;
    const auto triangle = all.subspan(j, 1);
    head.cone[j] = cone(area_vector(triangle).normalized(), triangle);
  }
  head.vertices = static_cast<std::uint8_t>(vertices.count);
  for (std::size_t i = 0; i < 3; ++i) head.origin[i] = (leaf.low[i] + leaf.high[i]) / 2;
  return head;
}

/// Gives the leaf's place, in units.
std::uint32_t Packer::add_leaf(const Branch& leaf) {
  LeafVertices vertices;
  LeafHead head = head_of(leaf, vertices);
  std::array<Vector, most_vertices> position;
  double reach = 0;
  for (std::size_t v = 0; v < vertices.count; ++v) {
    position[v] = vertex(vertices.number[v]) - Point(head.origin[0], head.origin[1], head.origin[2]);
    reach = std::max(reach, position[v].cwiseAbs().maxCoeff());
  }
  int exponent = 0;
  std::frexp(reach, &exponent);
  head.exponent = static_cast<std::int16_t>(std::max(exponent, smallest_exponent));
  const double per_unit = std::ldexp(1.0, -head.exponent);

  const std::size_t at = result_.leaves.size();
  result_.leaves.resize(at + units_of(head));
  unsigned char* out = result_.leaves[at].bytes;
  const auto append = [&](const auto& value) {
    std::memcpy(out, &value, sizeof value);
    out += sizeof value;
  };
  append(head);
  for (Eigen::Index i = 0; i < 3; ++i)
    for (std::size_t v = 0; v < vertices.count; ++v) append(static_cast<float>(position[v][i] * per_unit));
  for (std::size_t v = 0; v < vertices.count; ++v) append(vertices.number[v]);
  for (const std::uint32_t triangle : triangles(leaf)) append(triangle);
  ++leaf_count_;
  const Floats4 extent = leaf.high - leaf.low;
  sum_of_sizes_ += std::max({extent[0], extent[1], extent[2]});
  return static_cast<std::uint32_t>(at);
}

Vector Packer::area_vector(std::span<const std::uint32_t> part) const {
  Vector sum = Vector::Zero();
  for (const std::uint32_t triangle : part) {
    const Mesh::Face& corner = surface_.corners(triangle);
    const Point a = vertex(corner[0]);
    sum += (vertex(corner[1]) - a).cross(vertex(corner[2]) - a);
  }
  return sum;
}

//! [slab]
/// The slab of a child along its mean normal n, which is stored in 127ths. Heights n.(x - origin) are between
/// -half and half, and are stored in 65,535ths of that.
void Packer::write_slab(Node& node, std::size_t j, const Branch& child) const {
  node.slab[1][j] = 65535;
  const double half = 255.0 * (double{node.step[0]} + double{node.step[1]} + double{node.step[2]});
  if (child.count > most_in_a_slab || !(half > 0)) return;
  const Vector area = area_vector(triangles(child));
  const double length = area.norm();
  if (!(length > 0)) return;
  Vector normal;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    node.normal[i][j] = static_cast<std::int8_t>(127 * area[k] / length);
    normal[k] = node.normal[i][j] / 127.0;
  }
  double low = half, high = -half;
  const Point origin(node.origin[0], node.origin[1], node.origin[2]);
  for (const std::uint32_t triangle : triangles(child))
    for (const std::uint32_t corner : surface_.corners(triangle)) {
      const double height = normal.dot(vertex(corner) - origin);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  const auto step_at = [&](double height) { return (height / half + 1) * (65535 / 2.0); };
  node.slab[0][j] = static_cast<std::uint16_t>(std::clamp(std::floor(step_at(low) - 1e-3), 0.0, 65535.0));
  node.slab[1][j] = static_cast<std::uint16_t>(std::clamp(std::ceil(step_at(high) + 1e-3), 0.0, 65535.0));
  if (child.leaf()) node.cone[j] = cone(normal, triangles(child));
}
//! [slab]

/// Origin and steps of a node, and the boxes of its children in these steps, rounded outward.
void write_boxes(Node& node, const Branch& whole, const std::vector<Branch>& branches, const Cover& cover) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double origin = whole.low[i], extent = whole.high[i] - origin;
    int exponent = 0;
    std::frexp(extent / 255, &exponent);
    const double step = extent > 0 ? std::ldexp(1.0, exponent) : 0;
    node.origin[i] = whole.low[i];
    node.step[i] = static_cast<float>(step);
    for (std::size_t j = 0; j < width; ++j) {
      if (step == 0 || j >= static_cast<std::size_t>(cover.count)) continue;
      const Branch& child = branches[cover.branch[j]];
      node.side[i][j] = static_cast<std::uint8_t>(std::floor((child.low[i] - origin) / step));
      node.side[3 + i][j] = static_cast<std::uint8_t>(std::ceil((child.high[i] - origin) / step));
    }
  }
}

/// Leaves that are children of one node lie together, and so do its inner children, for which this makes
/// room.
void Packer::write_children(Node& node, const Cover& cover) {
  node.first_node = static_cast<std::uint32_t>(result_.nodes.size()) & most_nodes;
  node.first_leaf = static_cast<std::uint32_t>(result_.leaves.size());
  std::uint8_t inner = 0;
  for (std::size_t j = 0; j < node.count; ++j) {
    const Branch& child = branch(cover.branch[j]);
    node.child[j] =
        child.leaf() ? static_cast<std::uint8_t>(128 + add_leaf(child) - node.first_leaf) : inner++;
    write_slab(node, j, child);
  }
  result_.nodes.resize(result_.nodes.size() + inner);
}

Node Packer::make_node(std::uint32_t number, const Cover& cover) {
  Node node{};
  node.count = static_cast<std::uint32_t>(cover.count) & 15;
  write_boxes(node, branch(number), tree_.branches, cover);
  write_children(node, cover);
  return node;
}

Node Packer::subtree(std::uint32_t number) {
  const Cover cover = collapse_.children(number);
  Node top = make_node(number, cover);
  for (std::size_t j = 0; j < top.count; ++j)
    if (!(top.child[j] & 128)) attach(top, j, subtree(cover.branch[j]));
  return top;
}

/// Puts an inner child in its place.
void Packer::attach(Node& parent, std::size_t j, const Node& child) {
  result_.nodes[parent.first_node + parent.child[j]] = child;
  parent.leaves_of[j] = child.first_leaf;
}

//! [pack_in_parallel]
/// The subtrees below the root are packed at the same time, each in memory of its own, and then put one
/// behind the other.
PackedTree Packer::pack() {
  if (branch(0).leaf()) {
    result_.root = leaf_bit | add_leaf(branch(0));
    return finish();
  }
  const Cover cover = collapse_.children(0);
  result_.nodes.resize(1);
  Node top = make_node(0, cover);
  const Packer empty(tree_, collapse_, surface_, space_, cones_);
  std::vector<Packer> parts(cover.branch.size(), empty);
  std::array<Node, width> child{};
  in_turns(cover, [&](std::size_t j) { child[j] = parts[j].subtree(cover.branch[j]); });
  for (std::size_t j = 0; j < top.count; ++j)
    if (!(top.child[j] & 128)) attach(top, j, append(parts[j], child[j]));
  result_.nodes[0] = top;
  result_.root = 0;
  return finish();
}
//! [pack_in_parallel]

/// Calls work(j) for the inner children of the root, on all processors, the largest first.
template <class Work>
void Packer::in_turns(const Cover& cover, const Work& work) const {
  std::vector<std::size_t> turns;
  for (std::size_t j = 0; j < static_cast<std::size_t>(cover.count); ++j)
    if (!branch(cover.branch[j]).leaf()) turns.push_back(j);
  const auto size = [&](std::size_t j) { return branch(cover.branch[j]).count; };
  std::sort(turns.begin(), turns.end(), [&](std::size_t i, std::size_t j) { return size(i) > size(j); });
  in_parallel(threads_for(tree_.order.size()), turns.size(), [&](std::size_t i) { work(turns[i]); });
}

/// Puts another packer's nodes and leaves behind this one's. \returns its topmost node, moved
Node Packer::append(const Packer& part, const Node& top) {
  const auto nodes = static_cast<std::uint32_t>(result_.nodes.size());
  const auto leaves = static_cast<std::uint32_t>(result_.leaves.size());
  const auto move = [&](Node& node) {
    node.first_node = (node.first_node + nodes) & most_nodes;
    node.first_leaf += leaves;
    for (std::uint32_t& first : node.leaves_of) first += leaves;
    return node;
  };
  result_.nodes.insert(result_.nodes.end(), part.result_.nodes.begin(), part.result_.nodes.end());
  result_.leaves.insert(result_.leaves.end(), part.result_.leaves.begin(), part.result_.leaves.end());
  std::for_each(result_.nodes.begin() + nodes, result_.nodes.end(), move);
  leaf_count_ += part.leaf_count_;
  sum_of_sizes_ += part.sum_of_sizes_;
  Node moved = top;
  return move(moved);
}

PackedTree Packer::finish() {
  result_.leaf_size = static_cast<float>(sum_of_sizes_ / static_cast<double>(leaf_count_));
  result_.leaves.resize(result_.leaves.size() + read_past_the_end);
  result_.leaves.shrink_to_fit();
  result_.nodes.shrink_to_fit();
  return std::move(result_);
}

}  // namespace

PackedTree pack(const BinaryTree& tree, const Surface& surface, const Space& space) {
  if (tree.order.empty()) return {};
  const Collapse collapse(tree.branches);
  const NormalCones cones(surface, space);
  return Packer(tree, collapse, surface, space, cones).pack();
}

}  // namespace first_contact::bvh
