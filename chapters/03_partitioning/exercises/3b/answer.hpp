#include "task.hpp"

// All pairs of things whose boxes overlap, each once, the smaller number first, in any order of pairs.
std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  return {};
}
