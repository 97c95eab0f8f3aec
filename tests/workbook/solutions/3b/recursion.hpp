#include "task.hpp"

using Pairs = std::vector<std::pair<int, int>>;

static void visit(const std::vector<Node>& tree, const std::vector<Bounds>& things, std::size_t place,
                  Pairs& pairs) {
  for (const int child : tree[place].children) visit(tree, things, static_cast<std::size_t>(child), pairs);
  for (const int a : tree[place].things)
    for (const int b : tree[place].things)
      if (a < b && overlap(things[static_cast<std::size_t>(a)], things[static_cast<std::size_t>(b)]))
        pairs.push_back({a, b});
}

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  Pairs pairs;
  visit(tree, things, 0, pairs);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}
