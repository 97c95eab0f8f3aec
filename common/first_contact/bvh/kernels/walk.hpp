#pragma once
#include "first_contact/bvh/build/layout.hpp"

/// \file
/// The way of one cast through the tree, from leaf to leaf, nearest first.
///
/// The idea: floats say "certainly not", eight boxes or triangles at a time, or, of a face, "certainly so";
/// doubles decide about the few that are left, and when exactly it is. So whatever the floats round, the
/// answer is that of the plain sweep, bit for bit, on every instruction set. A walk can pause after each node,
/// so that many casts may take turns while their memory is on its way.
///
/// This header is read by files compiled for different instruction sets: plain data only, no functions.

namespace first_contact::bvh {

/// A node or a leaf, and a time before which nothing in it is touched; or, if less than 0, how deep the sphere
/// overlaps it at the start, at most. \see limits.inc
struct Entry {
  Ref ref;
  float time;
};

/// A cast in the tree's unit, and how far it has got. Times here, tau, run from 0 to 1 over the part of the
/// path that is near the mesh.
struct Walk {
  // Found by begin(): the part of the path that is near the mesh, in the tree's unit.
  double start[4], travel[4];  ///< the centre's; three numbers and 0
  double radius;
  double error;                ///< positions, radius and the doubles that decide are wrong by less than this
  double from_time, duration;  ///< when this part begins, of the cast's own time, and how long it lasts

  // Kept up to date by the walk, and by whoever decides:
  float latest;  ///< contacts later than this do not matter; rounded up. Below 0: \see Verdict::depth

  // Where it pauses: the node or leaf that is next, or ...
  Entry entry;
  // ... a leaf, whose triangles with a bit ...
  const LeafHead* leaf;
  unsigned survivors;  ///< may be touched, ...
  float bound[width];  ///< ... not before these times, or, if less than 0, not deeper at the start;
  unsigned touched;    ///< are touched for certain, if they survive: their face, ...
  float late[width];   ///< ... by these times;
  unsigned untouched;  ///< are overlapped at the start, and only left

  // The walk's own; along the three axes, and a fourth that does not matter.
  float from[4], across[4];       // start and travel, rounded
  float way[4], inverse[4];       // |across|, and 1 / across
  float grown[4];                 // the radius, with its error, in the time that it takes
  float in[4], out[4];            // from / across, and so much more, or less
  int near_side[4], far_side[4];  // by which the path enters and leaves a box: \see Node
  float grown_radius;             // radius + error of what is decided in doubles
  float reach;                    // radius + error of boxes
  float bare;                     // radius, less all errors; cones are asked if it is more than 0
  float unsure;                   // at this distance, and nearer, cones know nothing
  bool brief;                     // is what is overlapped at the start touched only there? \see never_over
  float slab_slack;               // error for slabs; less than 0: slabs are not worth their time
  float length;                   // of the travel, rounded up
  int waiting;                    // entries on the stack: refs and times, and room for eight to be written
  Ref ref[most_waiting + width];
  float time[most_waiting + width];
};

/// What a walk has come to: a node, a leaf, a leaf with triangles that survive (then, in turns, their corners
/// are asked for), or its end.
enum class Stage { node, leaf, survivors, corners, end };

/// A cast in the unit of the mesh, for the doubles.
struct Question {
  const double *center, *travel;  // where the caller has them: three numbers each
  double radius;
};

/// What of a triangle may be touched in time.
struct Found {
  unsigned features;  ///< one bit each: the face, the edges ab, bc, ca, the vertices a, b, c
  bool within;        ///< it is the face, and surely far from its sides: \see touch_face
  double early[7];    ///< those with a bit are not touched before
  double late;  ///< by then the triangle is touched, as far as can be seen; infinite if that is not clear
};

/// The same code compiled for one instruction set.
struct Walker {
  /// \returns whether the sphere comes near the mesh at all
  bool (*begin)(const Tree&, const Question&, Walk&);
  Stage (*next)(const Tree&, Walk&);  ///< goes on to the next leaf with survivors, or to the end
  ///@{
  /// In small steps: goes on from the start, or from survivors, to what is next; looks into one node; into
  /// one leaf.
  Stage (*resume)(Walk&);
  Stage (*visit_node)(const Tree&, Walk&);
  Stage (*visit_leaf)(const Tree&, Walk&);
  ///@}
  /// What of the triangle abc may be touched in time? It may be that it overlaps the sphere at the start.
  Found (*features_in_time)(const Question&, const double* a, const double* b, const double* c, double latest,
                            bool overlapping);
};

/// Runs everywhere.
extern const Walker portable_walker;
/// Needs AVX2 and FMA; without functions where the compiler has none for this kind of processor.
extern const Walker avx2_walker;

}  // namespace first_contact::bvh
