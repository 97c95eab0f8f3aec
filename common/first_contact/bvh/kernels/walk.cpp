// The walk through the tree. This file is read once for each kind of processor. Left out are those whose
// vectors have no fixed length, those that differ little from one that is there, and AVX-512: of eight lanes
// its masks take longer than AVX2's, and picking from sixteen at once slows down all else (a hop in 2,048
// triangles: 252 ns, of AVX2 219).
#if defined(__aarch64__)
// Of ARM's one kind is left. So Highway need not ask the system for the kind at hand, and asks no more of the
// compiler than its own flags do: GCC cannot make structs of vectors of a kind that is not theirs.
#define TOOLCHAIN_MISS_SYS_AUXV_H
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "first_contact/bvh/kernels/walk.cpp"
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "first_contact/bvh/kernels/features.hpp"
#include "first_contact/bvh/kernels/over_cones.hpp"
#include "first_contact/bvh/kernels/slabs.hpp"
#include "first_contact/bvh/kernels/walker.hpp"

HWY_BEFORE_NAMESPACE();
namespace first_contact::bvh::HWY_NAMESPACE {
namespace {

/// How much of a child's leaves is fetched together with the child.
constexpr int lines_ahead = 4;

/// Asks for memory that will be read soon. Always inline: GCC takes a call that does nothing but fetch for
/// one that does nothing, and leaves it out.
HWY_INLINE void fetch(const void* address, int lines) {
  for (int i = 0; i < lines; ++i) __builtin_prefetch(static_cast<const char*>(address) + 64 * i);
}
HWY_INLINE void fetch_candidate(const Tree& tree, Ref ref) {
  if (ref & leaf_bit)
    fetch(&leaf_at(tree.leaves, ref), 4);
  else
    fetch(&tree.nodes[ref], 3);
}
/// The first leaves below a child, where it is a node.
HWY_INLINE void fetch_below(const Tree& tree, const Node& node, int j) {
  if (node.leaves_of[j]) fetch(tree.leaves + node.leaves_of[j], lines_ahead);
}

//! [push]
/// Puts the children in `open` on the stack, the nearest on top: each has its place above as many as are
/// farther. There is no jump in this that a processor could guess wrong.
HWY_INLINE void push(const Tree& tree, Progress& progress, const Node& node, unsigned open,
                     const Floats& enter) {
  // Times that are not negative are ordered like their bits, and made different by the lanes' numbers.
  const std::int32_t numbers[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const Ints keys = (patterns(enter) & all_ints(~7)) | read<Ints>(numbers);
  float times[width];
  std::int32_t key[width], farther[width];
  write(times, enter);
  write(key, keys);
  Ints places = all_ints(0);
  for (unsigned left = open; left; left &= left - 1)
    places = places + or_zero(keys < all_ints(key[__builtin_ctz(left)]), all_ints(1));
  write(farther, places);
  for (unsigned left = open; left; left &= left - 1) {
    const int j = __builtin_ctz(left);
    progress.stack[progress.waiting + farther[j]] = {child(node, j), times[j]};
    fetch_candidate(tree, child(node, j));
    fetch_below(tree, node, j);
  }
  progress.waiting += __builtin_popcount(open);
}
//! [push]

//! [descend]
/// Goes on from a node to the nearest of the children that the sphere may touch in time; the others wait.
/// \returns whether there is one
HWY_INLINE bool descend(const Tree& tree, const Path& path, Progress& progress, Candidate& candidate) {
  const Node& node = tree.nodes[candidate.ref];
  const Inside box = inside_boxes(path, node, progress.latest);
  unsigned open = ~bits(box.enter > box.leave) & ((1U << node.count) - 1);
  if (open && path.slab_slack >= 0) open &= within_slabs(path, node, box);
  if (!open) return false;
  if ((open & (open - 1)) != 0) {
    push(tree, progress, node, open, box.enter);
    candidate = progress.stack[--progress.waiting];
  } else {
    float times[width];
    write(times, box.enter);
    const int only = __builtin_ctz(open);
    fetch_below(tree, node, only);
    candidate = {child(node, only), times[only]};
  }
  return true;
}
//! [descend]

/// Takes what is certain over to the walk: what comes after a face that is touched is too late.
HWY_INLINE void settle(Progress& progress, const Certain& face, unsigned alive, float entry) {
  write(progress.late, (all(entry) + face.late) * all(1 + 0x1p-20F));
  progress.touched = face.touched;
  progress.untouched = face.never;
  for (unsigned left = alive & face.touched; left; left &= left - 1) {
    const float late = progress.late[__builtin_ctz(left)];
    progress.latest = late < progress.latest ? late : progress.latest;
  }
}

//! [look]
/// The triangles of a leaf that may be touched in time, and the times before which they are not. Further
/// steps are for those that are apart from the sphere and in doubt.
HWY_INLINE unsigned survivors(const Path& path, Progress& progress, float entry) {
  constexpr int most_steps = 3;
  const LeafHead& head = *progress.leaf;
  const InLeaf sphere = in_leaf(path, head, entry);
  const Triangles eight = triangles(head, sphere.centre);
  Floats later = all(0);
  unsigned alive = (1U << head.triangles) - 1, in_doubt = alive;
  for (int steps = 1; steps <= most_steps && (alive & in_doubt); ++steps) {
    const Step step = raise(eight, sphere, later);
    alive &= ~(step.never | bits(all(entry) + later > all(progress.latest)));
    if (!alive) return 0;
    if (steps > 1) continue;
    const Heights over = heights(eight, sphere);
    const bool several = (alive & (alive - 1)) != 0;
    if (path.bare > 0 && several)
      alive &= ~never_over(path, head, sphere, over, progress.latest - entry,
                           entry > 0 ? all(sphere.radius) : step.distance);
    const Certain face = certain(eight, sphere, over, step, !(entry > 0));
    settle(progress, face, alive, entry);
    in_doubt = ~(face.touched | face.never | bits(step.apart <= all(0)));
  }
  const Floats early = (all(entry) + later) * all(1 - 0x1p-22F);
  write(progress.early, early);
  return alive & ~bits(early > all(progress.latest));
}

/// Looks at the triangles of a leaf. \returns whether some survive
HWY_INLINE bool look(const Tree& tree, Walk& walk, const Candidate& leaf) {
  walk.progress.leaf = &leaf_at(tree.leaves, leaf.ref);
  walk.progress.survivors = survivors(walk.path, walk.progress, leaf.time);
  return walk.progress.survivors != 0;
}
//! [look]

//! [go_on]
/// Takes the nearest candidate that is not too late from the stack. \returns whether there is one
HWY_INLINE bool take(Progress& progress, Candidate& candidate) {
  while (progress.waiting > 0) {
    candidate = progress.stack[--progress.waiting];
    if (!(candidate.time > progress.latest)) return true;
  }
  return false;
}

Pause advance(const Tree& tree, Walk& walk) {
  Progress& progress = walk.progress;
  Candidate candidate;
  bool more = take(progress, candidate);
  while (more) {
    if (!(candidate.ref & leaf_bit)) {
      more = descend(tree, walk.path, progress, candidate) || take(progress, candidate);
    } else {
      if (look(tree, walk, candidate)) return Pause::survivors;
      more = take(progress, candidate);
    }
  }
  return Pause::end;
}
//! [go_on]

HWY_INLINE Pause pause_before(Progress& progress, const Candidate& candidate) {
  progress.next = candidate;
  return candidate.ref & leaf_bit ? Pause::leaf : Pause::node;
}

Pause resume(Walk& walk) {
  Candidate candidate;
  return take(walk.progress, candidate) ? pause_before(walk.progress, candidate) : Pause::end;
}

Pause visit_node(const Tree& tree, Walk& walk) {
  Candidate candidate = walk.progress.next;
  const bool down = descend(tree, walk.path, walk.progress, candidate);
  if (down) fetch_candidate(tree, candidate.ref);
  return down || take(walk.progress, candidate) ? pause_before(walk.progress, candidate) : Pause::end;
}

Pause visit_leaf(const Tree& tree, Walk& walk) {
  Candidate candidate = walk.progress.next;
  if (look(tree, walk, candidate)) return Pause::survivors;
  return take(walk.progress, candidate) ? pause_before(walk.progress, candidate) : Pause::end;
}

}  // namespace

const Walker* walker() {
  static const Walker all{
      hwy::TargetName(HWY_TARGET), advance, resume, visit_node, visit_leaf, features_in_time};
  return &all;
}

}  // namespace first_contact::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace first_contact::bvh {

HWY_EXPORT(walker);

const Walker& best_walker() { return *HWY_DYNAMIC_DISPATCH(walker)(); }

std::vector<const Walker*> all_walkers() {
  std::vector<const Walker*> all;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    all.push_back(&best_walker());
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return all;
}

}  // namespace first_contact::bvh
#endif
