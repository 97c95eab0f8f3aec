// Looks like: the search ends at the first disc that does not overlap, and not at the first that begins too
// far right.
// Ask: the next one begins in time, but lies far above. What of those after it?
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
    for (std::size_t j = i + 1; j < order.size() && overlap(disc(order[i]), disc(order[j])); ++j)
      pairs.push_back(std::minmax(order[i], order[j]));
  return pairs;
}
