// Looks like: a pair is listed once for each leaf that the two share.
// Ask: in how many leaves do two things stand that overlap where eight cells meet?
#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  std::vector<std::pair<int, int>> pairs;
  for (const Node& node : tree)
    for (const int a : node.things)
      for (const int b : node.things)
        if (a < b && overlap(things[static_cast<std::size_t>(a)], things[static_cast<std::size_t>(b)]))
          pairs.push_back({a, b});
  return pairs;
}
