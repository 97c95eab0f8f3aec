// Looks like: the numbers are places in the sorted list, not those of the discs.
// Ask: which disc is the third of the sorted list?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  auto sorted = discs;
  std::sort(sorted.begin(), sorted.end(),
            [](const Disc& a, const Disc& b) { return a.centre.x - a.radius < b.centre.x - b.radius; });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = i + 1; j < sorted.size(); ++j)
      if (overlap(sorted[i], sorted[j])) pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}
