#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "first_contact/bvh/build/surface.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

namespace first_contact {

/// A binary tree of boxes (bounding volume hierarchy) over the triangles of a mesh: for reading, and to test
/// bvh.hpp against.
///
/// The idea: put the triangles in a box, cut the box in two, and the halves again. What cannot reach a box
/// cannot touch anything in it. Unlike the cells of an octree, boxes of a triangle each may overlap, but no
/// triangle is in two of them.
class PlainBvh {
 public:
  /// Cuts boxes until few triangles are left in each.
  explicit PlainBvh(Mesh mesh);

  /// The surface.
  const Mesh& mesh() const { return mesh_; }
  /// Its triangles in the order of the leaves, for the sweep.
  const bvh::Surface& surface() const { return *surface_; }
  /// The number of boxes.
  std::size_t size() const { return nodes_.size(); }
  /// The number of levels.
  int depth() const;

  /// Calls consider(place) for the places in `surface()` of the triangles that the moving sphere may touch,
  /// the nearest boxes first. It returns the time up to which contacts still matter.
  template <class Consider>
  void visit(const Moving<Sphere>& moving, const Consider& consider) const;

 private:
  struct Cut;
  struct Bins;
  struct Box {
    Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
    void add(const Box& other);
    double surface() const;
  };
  struct Node {
    Box box;
    std::uint32_t first = 0, count = 0;  // its triangles in order_
    std::uint32_t children = 0;          // this node and the next; 0 for a leaf
  };
  /// A path of the centre, with all that is the same for each box.
  struct Path {
    explicit Path(const Moving<Sphere>& moving);
    double entry(const Box& box, double latest) const;
    Point start;
    Vector inverse;
    double radius;
  };

  void plant();
  void grow(std::vector<Box>& boxes, std::uint32_t number);
  std::uint32_t cut(const std::vector<Box>& boxes, const Node& node);
  int depth(const Node& node) const;

  Mesh mesh_;
  std::vector<Node> nodes_;  // the root first
  std::vector<std::uint32_t> order_;
  std::optional<bvh::Surface> surface_;
};

/// First contact of a moving sphere with a mesh, as sweep(moving, Environment) finds it, to the last bit.
std::optional<Contact> sweep(const Moving<Sphere>& moving, const PlainBvh& tree);

//! [visit_plain_bvh]
template <class Consider>
void PlainBvh::visit(const Moving<Sphere>& moving, const Consider& consider) const {
  struct Entry {
    const Node* node;
    double time;
  };
  const Path path(moving);
  double latest = 1;
  std::vector<Entry> waiting;
  const auto push = [&](const Node& node, double time) {
    if (time <= latest) waiting.push_back({&node, time});
  };
  if (!nodes_.empty()) push(nodes_[0], path.entry(nodes_[0].box, latest));
  while (!waiting.empty()) {
    const auto [node, time] = waiting.back();
    waiting.pop_back();
    if (time > latest) continue;
    if (node->children == 0) {
      for (std::uint32_t i = 0; i < node->count; ++i) latest = std::min(latest, consider(node->first + i));
      continue;
    }
    const Node &left = nodes_[node->children], &right = nodes_[node->children + 1];
    const double enter_left = path.entry(left.box, latest), enter_right = path.entry(right.box, latest);
    if (enter_left < enter_right) {  // the nearer one last, so that it comes first from the stack
      push(right, enter_right);
      push(left, enter_left);
    } else {
      push(left, enter_left);
      push(right, enter_right);
    }
  }
}
//! [visit_plain_bvh]

}  // namespace first_contact
