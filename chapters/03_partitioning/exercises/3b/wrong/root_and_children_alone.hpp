// Looks like: only the root and its children are visited: what lies deeper is missed.
// Ask: how deep is the tree, and who visits the children of the children?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> nodes{0};
  for (const int child : tree[0].children) nodes.push_back(child);
  for (const int node : nodes)
    for (const int a : tree[static_cast<std::size_t>(node)].things)
      for (const int b : tree[static_cast<std::size_t>(node)].things)
        if (a < b && overlap(things[static_cast<std::size_t>(a)], things[static_cast<std::size_t>(b)]) &&
            std::find(pairs.begin(), pairs.end(), std::pair{a, b}) == pairs.end())
          pairs.push_back({a, b});
  return pairs;
}
