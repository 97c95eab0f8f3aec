#pragma once
#include "first_contact/bvh/build/layout.hpp"
#include "first_contact/bvh/kernels/path.hpp"

/// \file
/// How far one cast has got on its way through the tree, from leaf to leaf, nearest first.
///
/// The idea: floats say "certainly not", eight boxes or triangles at a time, or, of a face, "certainly so";
/// doubles decide about the few that are left, and when exactly it is. So whatever the floats round, the
/// answer is that of the plain sweep, bit for bit, on every instruction set. A walk can pause after each node,
/// so that many casts may take turns while their memory is on its way.

namespace first_contact::bvh {

/// A node or a leaf that may be looked into, and a time before which nothing in it is touched.
struct Candidate {
  Ref ref;
  float time;
};

struct Progress {
  /// Contacts later than this do not matter; rounded up. Kept up to date by whoever decides.
  float latest;

  // Where it pauses: the node or leaf that is next, or ...
  Candidate next;
  // ... a leaf, whose triangles with a bit ...
  const LeafHead* leaf;
  unsigned survivors;  ///< may be touched, ...
  float early[width];  ///< ... not before these times (0: they may be overlapped at the start);
  unsigned touched;    ///< are touched for certain, if they survive: their face, ...
  float late[width];   ///< ... by these times;
  unsigned untouched;  ///< are overlapped at the start, and only left

  // What waits, the nearest on top.
  int waiting;
  Candidate stack[most_waiting];
};

/// One cast on its way.
struct Walk {
  Path path;
  Progress progress;
};

/// Where a walk pauses: before a node, before a leaf, at a leaf with triangles that survive (then, in turns,
/// their corners are asked for), or at its end.
enum class Pause { node, leaf, survivors, corners, end };

/// Puts a walk at the root.
inline void start(const Tree& tree, Progress& progress) {
  progress.latest = 1 + 0x1p-20F;
  progress.waiting = 1;
  progress.stack[0] = {tree.root, 0};
}

}  // namespace first_contact::bvh
