#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "first_contact/geometry/environment.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"
#include "first_contact/trees/box_tree.hpp"

namespace first_contact {

/// An environment and the tree of boxes over its triangles: for reading, and to test bvh.hpp against, of which
/// it includes nothing.
class PlainBvh {
 public:
  /// Finds the edges, and cuts boxes until few triangles are left in each.
  explicit PlainBvh(Mesh mesh) : environment_(std::move(mesh)), tree_(environment_.mesh().triangles()) {}

  /// The surface.
  const Mesh& mesh() const { return environment_.mesh(); }
  /// With its edges.
  const Environment& environment() const { return environment_; }
  /// The boxes.
  const BoxTree& tree() const { return tree_; }

  /// Calls consider(triangle) for the numbers of the triangles that the moving sphere may touch, the nearest
  /// boxes first. It returns the time up to which contacts still matter.
  template <class Consider>
  void visit(const Moving<Sphere>& moving, const Consider& consider) const;

 private:
  /// A path of the centre, with all that is the same for each box.
  struct Path {
    explicit Path(const Moving<Sphere>& moving);
    double entry(const Bounds& box, double latest) const;
    Point start;
    Vector inverse;
    double radius;
  };

  Environment environment_;
  BoxTree tree_;
};

/// Do the sphere and the surface share a point? As overlap(sphere, Environment) says it.
bool overlap(const Sphere& sphere, const PlainBvh& tree);

/// First contact of a moving sphere with a mesh, as sweep(moving, Environment) finds it, to the last bit.
std::optional<Contact> sweep(const Moving<Sphere>& moving, const PlainBvh& tree);

//! [visit_plain_bvh]
template <class Consider>
void PlainBvh::visit(const Moving<Sphere>& moving, const Consider& consider) const {
  struct Waiting {
    const BoxTreeNode* node;
    double time;
  };
  const Path path(moving);
  double latest = 1;
  std::vector<Waiting> waiting;
  const auto push = [&](const BoxTreeNode& node, double time) {
    if (time <= latest) waiting.push_back({&node, time});
  };
  if (mesh().size() > 0) push(tree_.node(0), path.entry(tree_.node(0).bounds, latest));
  while (!waiting.empty()) {
    const auto [node, time] = waiting.back();
    waiting.pop_back();
    if (time > latest) continue;
    if (node->is_leaf()) {
      for (std::uint32_t i = node->begin; i < node->end; ++i)
        latest = std::min(latest, consider(tree_.order()[i]));
      continue;
    }
    const BoxTreeNode &left = tree_.node(node->first_child), &right = tree_.node(node->first_child + 1);
    const double enter_left = path.entry(left.bounds, latest), enter_right = path.entry(right.bounds, latest);
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
