#include "task.hpp"

std::vector<std::pair<int, int>> overlapping_pairs(const std::vector<Node>& tree,
                                                   const std::vector<Bounds>& things) {
  std::vector<std::vector<bool>> found(things.size(), std::vector<bool>(things.size()));
  std::vector<std::pair<int, int>> pairs;
  for (std::vector<int> open{0}; !open.empty();) {
    const Node& node = tree[static_cast<std::size_t>(open.back())];
    open.pop_back();
    open.insert(open.end(), node.children.begin(), node.children.end());
    for (std::size_t i = 0; i < node.things.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto a = static_cast<std::size_t>(std::min(node.things[i], node.things[j])),
                   b = static_cast<std::size_t>(std::max(node.things[i], node.things[j]));
        if (found[a][b] || !overlap(things[a], things[b])) continue;
        found[a][b] = true;
        pairs.push_back({static_cast<int>(a), static_cast<int>(b)});
      }
  }
  return pairs;
}
