// Looks like: each pair is there twice, as (a, b) and as (b, a).
// Ask: is (5, 2) another pair than (2, 5)?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  std::vector<std::pair<int, int>> pairs;
  for (const Node& node : tree)
    for (const int a : node.things)
      for (const int b : node.things)
        if (a != b && overlap(things[static_cast<std::size_t>(a)], things[static_cast<std::size_t>(b)]) &&
            std::find(pairs.begin(), pairs.end(), std::pair{a, b}) == pairs.end())
          pairs.push_back({a, b});
  return pairs;
}
