#pragma once
#include "first_contact/bvh/build/layout.hpp"

/// \file
/// The way of one sphere, as the tree sees it: in the tree's unit, and in floats that exclude nothing wrongly.
///
/// This header is read by files compiled for different instruction sets: plain data, and functions that stand
/// in path.cpp.

namespace first_contact::bvh {

/// A cast in the unit of the mesh, for the doubles.
struct Question {
  const double *center, *travel;  // where the caller has them: three numbers each
  double radius;
};

/// Of (farthest + radius): sixty-four roundings. \see kernels/boxes.hpp
inline constexpr float box_error = 0x1p-18F;

/// Times here, tau, run from 0 to 1 over the part of the path that is near the mesh.
struct Path {
  double start[4], travel[4];  ///< of the centre, of this part; three numbers and 0
  double radius;
  double error;                ///< positions, radius and the doubles that decide are wrong by less than this
  double from_time, duration;  ///< when this part begins, of the cast's own time, and how long it lasts

  // The same in floats, along the three axes.
  float from[4], across[4];       ///< start and travel, rounded; three numbers and 0
  float inverse[3];               ///< 1 / across
  float in[3], out[3];            ///< - from / across, less, or and, the time that the radius takes
  int near_side[3], far_side[3];  ///< by which the path enters and leaves a box: \see Node
  float grown_radius;             ///< radius + error of what is decided in doubles
  float reach;                    ///< radius + error of boxes
  float bare;                     ///< radius, less all errors; cones are asked if it is more than 0
  float unsure;                   ///< at this distance, and nearer, cones know nothing
  bool brief;                     ///< is what is overlapped at the start touched only there? \see never_over
  float slab_slack;               ///< error for slabs; less than 0: slabs are not worth their time
  float length;                   ///< of the travel, rounded up
};

/// Brings a cast into the tree's unit, and cuts it down to what is near the mesh.
/// \returns whether the sphere comes near the mesh at all
bool find_path(const Tree& tree, const Question& question, Path& path);

}  // namespace first_contact::bvh
