// Looks like: the boxes around the discs are compared, and `overlap` is not asked.
// Ask: two discs stand corner to corner. Do they overlap where their boxes do?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      const Vector2 apart = discs[i].centre - discs[j].centre;
      if (std::max(std::abs(apart.x), std::abs(apart.y)) < discs[i].radius + discs[j].radius)
        pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
    }
  return pairs;
}
