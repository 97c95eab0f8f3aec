// Looks like: a thing that stands in one leaf already is left out of all others.
// Ask: a large thing reaches into four cells, and overlaps another one in the last of them. Where do you
// compare the two?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  std::vector<std::pair<int, int>> pairs;
  std::vector<bool> seen(things.size());
  for (const Node& node : tree) {
    std::vector<int> fresh;
    for (const int a : node.things)
      if (!seen[static_cast<std::size_t>(a)]) fresh.push_back(a);
    for (const int a : fresh) {
      seen[static_cast<std::size_t>(a)] = true;
      for (const int b : fresh)
        if (a < b && overlap(things[static_cast<std::size_t>(a)], things[static_cast<std::size_t>(b)]))
          pairs.push_back({a, b});
    }
  }
  return pairs;
}
