#pragma once
#include <vector>

#include "first_contact/bvh/kernels/progress.hpp"

/// \file
/// The functions that are compiled for each kind of processor, and chosen from when the program runs.

namespace first_contact::bvh {

/// What of a triangle may be touched in time.
struct Found {
  unsigned features;  ///< one bit each: the face, the edges ab, bc, ca, the vertices a, b, c
  bool within;        ///< it is the face, and surely far from its sides: \see touch_face
  double early[7];    ///< those with a bit are not touched before
  double late;  ///< by then the triangle is touched, as far as can be seen; infinite if that is not clear
};

/// All of them, for one kind of processor.
struct Walker {
  const char* name;                      ///< of the kind of processor, as Highway has it
  Pause (*advance)(const Tree&, Walk&);  ///< goes on to the next leaf with survivors, or to the end
  ///@{
  /// In small steps: goes on from the start, or from survivors, to what is next; looks into one node; into
  /// one leaf.
  Pause (*resume)(Walk&);
  Pause (*visit_node)(const Tree&, Walk&);
  Pause (*visit_leaf)(const Tree&, Walk&);
  ///@}
  /// What of the triangle abc may be touched in time? It may be that it overlaps the sphere at the start.
  Found (*features_in_time)(const Question&, const double* a, const double* b, const double* c, double latest,
                            bool overlapping);
};

/// The one for the machine that runs this.
const Walker& best_walker();
/// All that this machine can run: for tests, which compare them.
std::vector<const Walker*> all_walkers();

}  // namespace first_contact::bvh
