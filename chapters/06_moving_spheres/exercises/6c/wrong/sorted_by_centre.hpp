// Looks like: sorted by the centres, and the search ends at the first that begins too far right: a large one
// may come after it.
// Ask: the centre of a large disc is far to the right. Where does it begin?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  std::vector<int> order(discs.size());
  std::iota(order.begin(), order.end(), 0);
  const auto disc = [&](int i) { return discs[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return disc(a).centre.x < disc(b).centre.x; });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (disc(order[j]).centre.x - disc(order[j]).radius > disc(order[i]).centre.x + disc(order[i]).radius)
        break;
      if (overlap(disc(order[i]), disc(order[j]))) pairs.push_back(std::minmax(order[i], order[j]));
    }
  return pairs;
}
