// Appendix A: one cast on its way through the fast tree, step by step. It is the library's own walk: it goes by functions
// that can be exchanged, and here by some that note what the library's did.
#include <algorithm>
#include <string>
#include <vector>

#include "first_contact/bvh/cast/sphere_cast.hpp"
#include "page.hpp"
#include "throw.hpp"

using namespace first_contact;
using namespace first_contact::bvh;
using touch::tell;

namespace {

/// One node or leaf that is looked into.
struct Look {
  Ref ref;
  unsigned kept = 0;               // a bit for each child, or triangle, that may be touched in time
  std::vector<Candidate> waiting;  // after it
};
std::vector<Look> looks;

Look before(const Walk& walk) { return {walk.progress.next.ref}; }
void after(Look look, const Walk& walk) {
  look.waiting.assign(walk.progress.stack, walk.progress.stack + walk.progress.waiting);
  looks.push_back(look);
}

Pause note_node(const Tree& tree, Walk& walk) {
  Look look = before(walk);
  const int waited = walk.progress.waiting;
  const Pause pause = best_walker().visit_node(tree, walk);
  const Node& node = tree.nodes[look.ref];
  for (int j = 0; j < node.count; ++j) {
    const auto is_child = [&](const Candidate& each) { return each.ref == child(node, j); };
    const bool waits = std::any_of(walk.progress.stack + std::min(waited, walk.progress.waiting),
                                   walk.progress.stack + walk.progress.waiting, is_child);
    if (waits || (pause != Pause::end && is_child(walk.progress.next))) look.kept |= 1U << j;
  }
  after(look, walk);
  return pause;
}

Pause note_leaf(const Tree& tree, Walk& walk) {
  Look look = before(walk);
  const Pause pause = best_walker().visit_leaf(tree, walk);
  if (pause == Pause::survivors) look.kept = walk.progress.survivors;
  after(look, walk);
  return pause;
}

void take_notes(const Moving<Sphere>& ball, const Parts& parts) {
  Walker notes = best_walker();
  notes.visit_node = note_node;
  notes.visit_leaf = note_leaf;
  looks.clear();
  SphereCast cast(ball, parts, notes);
  do
    for (Pause at = cast.begin(); at != Pause::end;)
      at = at == Pause::node ? cast.visit_node() : at == Pause::leaf ? cast.visit_leaf() : cast.decide();
  while (!cast.finish());
}

// The box of a child: both its corners.
void add_box(std::vector<double>& boxes, const Tree& tree, const Node& node, int j) {
  for (int side : {0, 3})
    for (int i = 0; i < 3; ++i)
      boxes.push_back(tree.center[i] + (node.origin[i] + node.step[i] * node.side[side + i][j]) / tree.scale);
}

// The boxes of those that wait stand in their parents.
void tell_waiting(const Look& look, const Parts& parts) {
  std::vector<double> boxes;
  for (const Node& node : parts.packed.nodes)
    for (int j = 0; j < node.count; ++j)
      if (std::any_of(look.waiting.begin(), look.waiting.end(),
                      [&](const Candidate& each) { return each.ref == child(node, j); }))
        add_box(boxes, parts.tree, node, j);
  tell("drawn/waiting", boxes);
}

void tell_node(const Look& look, const Parts& parts) {
  const Node& node = parts.tree.nodes[look.ref];
  std::vector<double> kept, dropped;
  for (int j = 0; j < node.count; ++j) add_box(look.kept >> j & 1 ? kept : dropped, parts.tree, node, j);
  tell("drawn/kept", kept);
  tell("drawn/dropped", dropped);
}

void tell_leaf(const Look& look, const Parts& parts) {
  const LeafHead& leaf = leaf_at(parts.tree.leaves, look.ref);
  std::vector<double> kept, dropped;
  for (int j = 0; j < leaf.triangles; ++j)
    (look.kept >> j & 1 ? kept : dropped).push_back(face_of(leaf, j).number);
  tell("drawn/triangles/kept", kept);
  tell("drawn/triangles/dropped", dropped);
}

}  // namespace

FOR_THE_PAGE(fast_tree)
(double turn, double tilt, double hand_x, double hand_y, double aim_x, double aim_y, double radius,
 double step) {
  const Parts& parts = touch::bunny().parts();
  const touch::View view(turn, tilt, touch::middle_of(parts.mesh));
  view.tell();
  const Moving<Sphere> ball = touch::Throw{hand_x, hand_y, aim_x, aim_y, radius}.ball(view);
  touch::tell_contact(ball);
  take_notes(ball, parts);
  tell("drawn/steps", double(looks.size()));
  if (looks.empty() || step < 1) return;
  const Look& look = looks[std::min(std::size_t(step), looks.size()) - 1];
  look.ref& leaf_bit ? tell_leaf(look, parts) : tell_node(look, parts);
  tell_waiting(look, parts);
}
