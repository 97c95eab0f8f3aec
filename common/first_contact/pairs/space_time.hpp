#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "first_contact/geometry/space.hpp"

/// \file
/// Which of many boxes overlap? The boxes have four sides: three in space, and the time. What is at one place
/// at different times does not meet.

namespace first_contact {

/// Where something could be, and when: x, y, z and t.
struct SpaceTimeBox {
  /// x, y, z and t.
  using Corner = Eigen::Array<double, 4, 1, unaligned>;

  Corner low;         ///< the smallest of each
  Corner high;        ///< the largest of each
  std::size_t owner;  ///< the number of the thing
};

/// Do two boxes share more than their boundary?
inline bool overlap(const SpaceTimeBox& a, const SpaceTimeBox& b) {
  return (a.low < b.high).all() && (b.low < a.high).all();
}

/// Shows all pairs of boxes that overlap, each once, in no particular order, and brings the boxes into
/// another.
///
/// As quicksort: part the boxes at the middle one, along the axis on which they are spread widest for their
/// size, and find the pairs within each half. What is left are the pairs between the halves: only boxes that
/// reach the other half's bounds are in one, a thin layer, which is halved again in the same way. For boxes
/// of any sizes that overlap but few others, that takes a number of tests that grows like n log n; one that
/// overlaps all others costs one test for each of them more.
///
/// \returns how often a box was tested against another, or against the bounds of a half
std::size_t show_overlaps(std::span<SpaceTimeBox> boxes,
                          const std::function<void(const SpaceTimeBox&, const SpaceTimeBox&)>& show);

}  // namespace first_contact
