#include "first_contact/bvh/build/split.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "first_contact/bvh/build/layout.hpp"
#include "first_contact/bvh/build/parallel.hpp"
#include "first_contact/trees/bin_cut.hpp"

namespace first_contact::bvh {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::size_t most_bins = 16;
/// A few triangles need fewer bins.
constexpr std::size_t bins_for(std::size_t triangles) { return triangles <= 32 ? 8 : most_bins; }
/// So few triangles have no more than 16 vertices for certain.
constexpr std::uint32_t always_a_leaf = most_vertices / 3;
/// From this depth on parts are cut in halves by number, so that no mesh makes the tree deeper than
/// `deepest`: 2^32 triangles are 32 halvings.
constexpr int deepest_by_surface = deepest - 32;

Floats4 least(Floats4 a, Floats4 b) { return a < b ? a : b; }
Floats4 most(Floats4 a, Floats4 b) { return a > b ? a : b; }

struct Box {
  Floats4 low, high;
  static Box empty() {
    constexpr Floats4 far{infinite, infinite, infinite, infinite};
    return {far, -far};
  }
  void add(Floats4 l, Floats4 h) {
    low = least(low, l);
    high = most(high, h);
  }
  void add(const Box& other) { add(other.low, other.high); }
  float surface() const {
    const Floats4 d = high - low;
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

/// A triangle's box, and in the lanes to spare its number in two halves, which floats hold exactly.
struct Item {
  Floats4 low, high;
  static constexpr std::uint32_t half = 1 << 16;
  std::uint32_t number() const {
    return static_cast<std::uint32_t>(low[3]) + half * static_cast<std::uint32_t>(high[3]);
  }
  Floats4 middle() const { return low + high; }  // twice it
};

Item make_item(const Mesh& mesh, const Space& space, std::uint32_t number) {
  const Mesh::Face& face = mesh.faces()[number];
  const Point a = space.point(mesh.vertices()[face[0]]), b = space.point(mesh.vertices()[face[1]]),
              c = space.point(mesh.vertices()[face[2]]);
  const Eigen::Vector3f low = a.cwiseMin(b).cwiseMin(c).cast<float>(),
                        high = a.cwiseMax(b).cwiseMax(c).cast<float>();
  const std::uint32_t lower_half = number % Item::half, upper_half = number / Item::half;
  return {Floats4{low[0], low[1], low[2], static_cast<float>(lower_half)},
          Floats4{high[0], high[1], high[2], static_cast<float>(upper_half)}};
}

/// What a part is expected to cost: its surface times its number of leaves.
struct Part {
  Box box = Box::empty();
  std::uint32_t count = 0;

  void add(const Part& other) {
    box.add(other.box);
    count += other.count;
  }
  float work() const {
    if (count == 0) return 0;
    const std::uint32_t leaves = (count + width - 1) / width;
    return static_cast<float>(leaves) * box.surface();
  }
};

/// How the middles of some items fall into bins, along each axis.
struct Bins {
  Floats4 from, per_length;
  std::size_t bins;
  std::array<std::array<Part, most_bins>, 3> part;  // of each axis the first `bins`

  Bins(const Box& middles, std::size_t triangles) : from(middles.low), bins(bins_for(triangles)) {
    const Floats4 width = middles.high - middles.low, none{};
    per_length = width > none ? Floats4{} + 0.9999F * static_cast<float>(bins) / width : none;
  }
  std::size_t bin_of(const Item& item, int axis) const {
    return static_cast<std::size_t>((item.middle()[axis] - from[axis]) * per_length[axis]);
  }
  void add(const Item& item) {
    const Floats4 place = (item.middle() - from) * per_length;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto bin = static_cast<std::size_t>(place[axis]);
      part[axis][bin].box.add(item.low, item.high);
      ++part[axis][bin].count;
    }
  }
};

std::span<const Part> along(const Bins& in, int axis) {
  return std::span(in.part[static_cast<std::size_t>(axis)]).first(in.bins);
}

class Splitter {
 public:
  Splitter(const Surface& triangles, std::span<Item> all) : surface_(triangles), items_(all) {}

  /// The tree over some items; the root first.
  std::vector<Branch> tree(std::uint32_t first, std::uint32_t count, int depth, unsigned threads);

 private:
  bool small_enough(std::uint32_t first, std::uint32_t count) const;
  std::uint32_t cut(std::uint32_t first, std::uint32_t count, int depth, Branch& branch);
  void grow(std::vector<Branch>& branches, std::uint32_t at, int depth);

  const Surface& surface_;
  std::span<Item> items_;
};

bool Splitter::small_enough(std::uint32_t first, std::uint32_t count) const {
  if (count <= always_a_leaf) return true;
  if (count > width) return false;
  std::array<std::uint32_t, std::size_t{3} * width> seen{};
  auto end = seen.begin();
  for (const Item& item : items_.subspan(first, count))
    for (const std::uint32_t vertex : surface_.corners(item.number()))
      if (std::find(seen.begin(), end, vertex) == end) *end++ = vertex;
  return end - seen.begin() <= most_vertices;
}

/// Measures a part and cuts it in two; gives the size of the first part, or 0 for a leaf.
std::uint32_t Splitter::cut(std::uint32_t first, std::uint32_t count, int depth, Branch& branch) {
  const auto part = items_.subspan(first, count);
  Box box = Box::empty(), middles = box;
  for (const Item& item : part) {
    box.add(item.low, item.high);
    middles.add(item.middle(), item.middle());
  }
  branch = {box.low, box.high, first, count, 0};
  if (small_enough(first, count)) return 0;
  if (depth >= deepest_by_surface) return count / 2;

  Bins in(middles, count);
  for (const Item& item : part) in.add(item);
  BinCut<float> best;
  for (int axis = 0; axis < 3; ++axis) improve<most_bins>(best, along(in, axis), axis);
  if (best.axis < 0) return count / 2;  // all middles in one place
  const auto above = std::partition(part.begin(), part.end(),
                                    [&](const Item& item) { return in.bin_of(item, best.axis) <= best.bin; });
  const auto size = static_cast<std::uint32_t>(above - part.begin());
  return size == 0 || size == count ? count / 2 : size;
}

void Splitter::grow(std::vector<Branch>& branches, std::uint32_t at, int depth) {
  const auto [first, count] = std::pair(branches[at].first, branches[at].count);
  Branch branch;
  const std::uint32_t below = cut(first, count, depth, branch);
  branches[at] = branch;
  if (below == 0) return;
  const auto children = static_cast<std::uint32_t>(branches.size());
  branches[at].children = children;
  branches.resize(branches.size() + 2, Branch{});
  branches[children].first = first;
  branches[children].count = below;
  branches[children + 1].first = first + below;
  branches[children + 1].count = count - below;
  grow(branches, children, depth + 1);
  grow(branches, children + 1, depth + 1);
}

/// Puts the two trees below a root into one list.
std::vector<Branch> join(Branch root, const std::vector<Branch>& below, const std::vector<Branch>& above) {
  std::vector<Branch> result{root, below[0], above[0]};
  result[0].children = 1;
  result.reserve(1 + below.size() + above.size());
  const auto move_in = [&](const std::vector<Branch>& part, std::size_t its_root) {
    const auto shift = static_cast<std::uint32_t>(result.size() - 1);
    result.insert(result.end(), part.begin() + 1, part.end());
    for (std::size_t i = shift + 1; i < result.size(); ++i)
      if (!result[i].leaf()) result[i].children += shift;
    if (!part[0].leaf()) result[its_root].children += shift;
  };
  move_in(below, 1);
  move_in(above, 2);
  return result;
}

std::vector<Branch> Splitter::tree(std::uint32_t first, std::uint32_t count, int depth, unsigned threads) {
  Branch root{Floats4{}, Floats4{}, first, count, 0};
  if (threads <= 1) {
    std::vector<Branch> branches{root};
    branches.reserve(count / 2 + 1);
    grow(branches, 0, depth);
    return branches;
  }
  const std::uint32_t half = cut(first, count, depth, root);
  if (half == 0) return {root};
  std::vector<Branch> below, above;
  in_parallel(2, 2, [&](std::size_t part) {
    if (part == 0)
      below = tree(first, half, depth + 1, threads / 2);
    else
      above = tree(first + half, count - half, depth + 1, threads - threads / 2);
  });
  return join(root, below, above);
}

}  // namespace

BinaryTree split(const Surface& surface, const Space& space) {
  const Mesh& mesh = surface.mesh();
  const auto n = static_cast<std::uint32_t>(mesh.size());
  std::vector<Item> items(n);
  in_parallel_ranges(n, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) items[i] = make_item(mesh, space, static_cast<std::uint32_t>(i));
  });
  BinaryTree tree;
  tree.branches = Splitter(surface, items).tree(0, n, 0, threads_for(n));
  tree.order.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) tree.order[i] = items[i].number();
  return tree;
}

}  // namespace first_contact::bvh
