// Looks like: each disc is compared with its neighbour in the sorted list alone.
// Ask: a large disc reaches over three small ones. With how many of them is it compared?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  std::vector<int> order(discs.size());
  std::iota(order.begin(), order.end(), 0);
  const auto disc = [&](int i) { return discs[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return disc(a).centre.x - disc(a).radius < disc(b).centre.x - disc(b).radius;
  });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 1; i < order.size(); ++i)
    if (overlap(disc(order[i - 1]), disc(order[i]))) pairs.push_back(std::minmax(order[i - 1], order[i]));
  return pairs;
}
