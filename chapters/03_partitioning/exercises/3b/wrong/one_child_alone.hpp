// Looks like: the walk goes down into one child of each node only: the pairs of all other leaves are missed.
// Ask: a thing reaches into two cells. In which of them is the one that it overlaps?
// Seen in: melonJS (melonjs/melonJS, PR 1580) lost 12 of 20 overlapping pairs to a query that pruned too much
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  std::vector<std::pair<int, int>> pairs;
  std::size_t node = 0;
  while (!tree[node].children.empty()) node = static_cast<std::size_t>(tree[node].children.front());
  for (const int a : tree[node].things)
    for (const int b : tree[node].things)
      if (a < b && overlap(things[static_cast<std::size_t>(a)], things[static_cast<std::size_t>(b)]))
        pairs.push_back({a, b});
  return pairs;
}
