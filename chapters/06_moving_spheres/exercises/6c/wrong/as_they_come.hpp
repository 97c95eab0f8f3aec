// Looks like: the pairs are as they come from the sorted list: often the larger number stands first.
// Ask: is (5, 2) in the form that was asked for?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  std::vector<int> order(discs.size());
  std::iota(order.begin(), order.end(), 0);
  const auto disc = [&](int i) { return discs[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return disc(a).centre.x - disc(a).radius < disc(b).centre.x - disc(b).radius;
  });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j)
      if (overlap(disc(order[i]), disc(order[j]))) pairs.push_back({order[i], order[j]});
  return pairs;
}
