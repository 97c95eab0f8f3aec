// Looks like: the list is not sorted, and the search ends at the first that begins too far right.
// Ask: who says that what follows begins later?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      if (discs[j].centre.x - discs[j].radius > discs[i].centre.x + discs[i].radius) break;
      if (overlap(discs[i], discs[j])) pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
    }
  return pairs;
}
