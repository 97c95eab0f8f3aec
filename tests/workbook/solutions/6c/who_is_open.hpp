#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  std::vector<std::pair<double, int>> begins;
  for (std::size_t i = 0; i < discs.size(); ++i)
    begins.push_back({discs[i].centre.x - discs[i].radius, static_cast<int>(i)});
  std::sort(begins.begin(), begins.end());
  std::vector<std::pair<int, int>> pairs;
  std::vector<std::size_t> open;
  for (const auto& [x, number] : begins) {
    const auto i = static_cast<std::size_t>(number);
    std::erase_if(open, [&, left = x](std::size_t j) { return discs[j].centre.x + discs[j].radius < left; });
    for (const std::size_t j : open)
      if (overlap(discs[i], discs[j]))
        pairs.push_back({static_cast<int>(std::min(i, j)), static_cast<int>(std::max(i, j))});
    open.push_back(i);
  }
  return pairs;
}
