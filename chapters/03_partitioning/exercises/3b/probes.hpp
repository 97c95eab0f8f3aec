#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge needs no tree: it compares all with all.
inline std::vector<std::pair<int, int>> judge(const std::vector<Node>&, const std::vector<Bounds>& things) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < things.size(); ++i)
    for (std::size_t j = i + 1; j < things.size(); ++j)
      if (overlap(things[i], things[j])) pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}

/// Cuts a cell until there are few things in it; returns the place of its node.
inline int grow(std::vector<Node>& tree, const std::vector<Bounds>& things, const Bounds& cell,
                const std::vector<int>& inside, int depth) {
  const int place = static_cast<int>(tree.size());
  tree.push_back({});
  if (inside.size() <= 2 || depth == 0) {
    tree.back().things = inside;
    return place;
  }
  const Point middle = 0.5 * (cell.least + cell.most);
  for (int octant = 0; octant < 8; ++octant) {
    Bounds part = cell;
    (octant & 1 ? part.least.x : part.most.x) = middle.x;
    (octant & 2 ? part.least.y : part.most.y) = middle.y;
    (octant & 4 ? part.least.z : part.most.z) = middle.z;
    std::vector<int> within;
    for (const int thing : inside)
      if (overlap(things[static_cast<std::size_t>(thing)], part)) within.push_back(thing);
    if (within.empty()) continue;
    const int child = grow(tree, things, part, within, depth - 1);
    tree[static_cast<std::size_t>(place)].children.push_back(child);
  }
  return place;
}

inline std::tuple<std::vector<Node>, std::vector<Bounds>> scene(const std::vector<Bounds>& things) {
  std::vector<Node> tree;
  std::vector<int> all(things.size());
  std::iota(all.begin(), all.end(), 0);
  grow(tree, things, {{-8, -8, -8}, {8, 8, 8}}, all, 3);
  return {tree, things};
}

inline Bounds cube(Point Q, double size) {
  const Vector half = size / 2 * Vector{1, 1, 1};
  return Bounds{Q - half, Q + half};
}

inline std::vector<Exercise<Signature>::Chosen> chosen() {
  return {
      {"nothing overlaps, but two share a leaf", scene({cube({1, 1, 1}, 1), cube({3, 3, 3}, 1)})},
      {"two overlap in one leaf", scene({cube({1, 1, 1}, 2), cube({2, 2, 2}, 2)})},
      {"two overlap in the last of the leaves",
       scene({cube({-4, -4, -4}, 1), cube({-6, -6, -6}, 1), cube({5, 5, 5}, 2), cube({6, 6, 6}, 2)})},
      {"two overlap across several leaves: listed in each",
       scene({cube({0, 0, 0}, 3), cube({1, 0, 0}, 3), cube({6, 6, 6}, 1)})},
      {"one large thing over many small ones",
       scene({cube({0, 0, 0}, 9), cube({-3, -3, -3}, 1), cube({3, 3, 3}, 1), cube({3, -3, 3}, 1),
              cube({7, 7, 7}, 1)})},
      {"the larger number stands first in no pair",
       scene({cube({5, 5, 5}, 2), cube({-5, -5, -5}, 2), cube({-6, -5, -5}, 2), cube({6, 5, 5}, 2)})},
      {"no things at all", scene({})},
  };
}

inline Exercise<Signature> exercise() {
  Exercise<Signature> probes;
  probes.asked = "all pairs of things whose boxes overlap, each once, the smaller number first";
  probes.names = {"tree", "things"};
  probes.chosen = chosen();
  probes.random = [](Chance& chance) {
    std::vector<Bounds> things;
    for (std::size_t n = 3 + chance.below(12); n > 0; --n)
      things.push_back(cube(chance.vector(6), chance.number(0.5, 5)));
    return scene(things);
  };
  probes.mend = [](const auto& input) { return scene(std::get<1>(input)); };
  probes.allowed = [](const auto& input) {
    for (const Bounds& box : std::get<1>(input))
      if (!(box.least.x < box.most.x && box.least.y < box.most.y && box.least.z < box.most.z)) return false;
    return true;
  };
  probes.judge = judge;
  probes.any_order = true;
  probes.along = {"x of the first thing (number in the first pair)", -6, 6, [](auto& input, double at) {
                    auto things = std::get<1>(input);
                    if (things.empty()) return;
                    const double size = things[0].most.x - things[0].least.x;
                    things[0].least.x = at - size / 2, things[0].most.x = at + size / 2;
                    input = scene(things);
                  }};
  return probes;
}
