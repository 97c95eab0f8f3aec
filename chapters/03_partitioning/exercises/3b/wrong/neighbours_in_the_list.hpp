// Looks like: in a leaf only things that stand beside each other in the list are compared.
// Ask: three things are in a leaf. How many pairs can they make?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  std::vector<std::pair<int, int>> pairs;
  for (const Node& node : tree)
    for (std::size_t i = 1; i < node.things.size(); ++i) {
      const int a = node.things[i - 1], b = node.things[i];
      if (overlap(things[static_cast<std::size_t>(a)], things[static_cast<std::size_t>(b)]) &&
          std::find(pairs.begin(), pairs.end(), std::pair{a, b}) == pairs.end())
        pairs.push_back({a, b});
    }
  return pairs;
}
