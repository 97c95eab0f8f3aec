#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Disc>& discs) {
  std::vector<int> order(discs.size());
  std::iota(order.begin(), order.end(), 0);
  const auto disc = [&](int i) { return discs[static_cast<std::size_t>(i)]; };
  const auto begins = [&](int i) { return disc(i).centre.x - disc(i).radius; };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return begins(a) < begins(b); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1;
         j < order.size() && begins(order[j]) < disc(order[i]).centre.x + disc(order[i]).radius; ++j)
      if (overlap(disc(order[i]), disc(order[j]))) pairs.push_back(std::minmax(order[i], order[j]));
  return pairs;
}
