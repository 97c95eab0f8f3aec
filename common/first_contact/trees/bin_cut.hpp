#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace first_contact {

/// Where some things are cut in two: along an axis, after a bin; and the work to expect then.
///
/// The idea: a cut is good if few searches must look at both sides. The chance that a path that meets a box
/// meets a box inside it is the ratio of their surfaces, so the work to expect of a cut is the sum of surface
/// times the work inside, of both parts (the surface area heuristic; Goldsmith and Salmon 1987). Only the cuts
/// between bins are looked at (Wald 2007).
template <class Work>
struct BinCut {
  int axis = -1;        ///< none
  std::size_t bin = 0;  ///< the last one of the lower part
  /// What is to be expected of it: the sum of surface times work, of both parts.
  Work work = std::numeric_limits<Work>::infinity();
  std::size_t larger = 0;  ///< how many things are in the larger part

  /// Of two cuts as good, as on a straight line, whose parts have no surface, the more even one.
  bool operator<(const BinCut& other) const {
    return std::pair(work, larger) < std::pair(other.work, other.larger);
  }
};

//! [best_cut]
/// Finds the best of the cuts between bins along an axis, if it is better than what is known. Works from above
/// first, then, from below, the sums.
/// \param bins  what is in each: parts with `count`, `add(part)` and `work()`, which is 0 for none
template <std::size_t most_bins, class Part, class Work>
void improve(BinCut<Work>& best, std::span<const Part> bins, int axis) {
  constexpr Work infinite = std::numeric_limits<Work>::infinity();
  std::array<Work, most_bins> work_above{};
  Part above, below;
  std::size_t all = bins[0].count;
  for (std::size_t i = bins.size() - 1; i > 0; --i) {
    above.add(bins[i]);
    all += bins[i].count;
    work_above[i] = above.count > 0 ? above.work() : infinite;
  }
  for (std::size_t i = 0; i + 1 < bins.size(); ++i) {
    below.add(bins[i]);
    if (below.count == 0) continue;
    const std::size_t larger = std::max<std::size_t>(below.count, all - below.count);
    const BinCut<Work> cut{axis, i, below.work() + work_above[i + 1], larger};
    if (cut < best) best = cut;
  }
}
//! [best_cut]

}  // namespace first_contact
