// Looks like: whatever shares a leaf is called a pair, whether the boxes overlap or not.
// Ask: two small things lie in two corners of one cell. Do they overlap?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  std::vector<std::pair<int, int>> pairs;
  for (const Node& node : tree)
    for (const int a : node.things)
      for (const int b : node.things)
        if (a < b && !things.empty() && std::find(pairs.begin(), pairs.end(), std::pair{a, b}) == pairs.end())
          pairs.push_back({a, b});
  return pairs;
}
