#pragma once
#include <cstdint>
#include <vector>

#include "grounds.hpp"

/// \file
/// Slides frame after frame over whole surfaces, and what must not happen on the way, measured in each frame.
/// The chapter walks some thousand frames, ./course verify a million.

namespace walks {

//! [walk_result]
/// What is worst in all frames, lengths in units of the surface's largest coordinate.
struct Walk {
  long frames = 0;
  long contacts = 0;
  long tunnelled = 0;        ///< frames that end on the other side of the surface
  long reversed = 0;         ///< frames that end behind where they began, by more than `limit`
  long exhausted = 0;        ///< frames that had more contacts than are allowed
  double depth = -1;         ///< by how much the surface was nearer to the centre than the radius
  double backwards = 0;      ///< how far a frame ended behind where it began
  double drift = 0;          ///< how far a coordinate moved that must not change
  double seconds = 0;        ///< spent in `slide`
  std::vector<Point> trail;  ///< the centre, at the end of each frame

  /// How deep, how far back a ball may be.
  static constexpr double limit = 1e-9;
  /// How far what lies still may move.
  static constexpr double drift_limit = 1e-13;

  /// Has it touched the surface, and has nothing happened that must not?
  bool good() const;
};
//! [walk_result]

/// Walks so many frames; the seed tells which way.
Walk walk(const Ground& ground, long frames, std::uint64_t seed);

}  // namespace walks
