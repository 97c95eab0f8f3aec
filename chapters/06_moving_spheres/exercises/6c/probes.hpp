#pragma once
#include "task.hpp"
#include "workbook/sheet_of.hpp"

/// The judge compares all with all.
inline std::vector<std::pair<int, int>> judge(const std::vector<Disc>& discs) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      if (overlap(discs[i], discs[j])) pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}

inline Exercise<Signature> exercise() {
  using Discs = std::vector<Disc>;
  Exercise<Signature> probes;
  probes.asked = "all pairs of discs that overlap, each once, the smaller number first";
  probes.names = {"discs"};
  probes.chosen = {
      {"two that overlap", {Discs{{{0, 0}, 1}, {{1, 0}, 1}}}},
      {"two that do not", {Discs{{{0, 0}, 1}, {{3, 0}, 1}}}},
      {"one above the other: they overlap in x alone", {Discs{{{0, 0}, 1}, {{0.5, 5}, 1}}}},
      {"side by side: they overlap in y alone", {Discs{{{0, 0}, 1}, {{5, 0.5}, 1}}}},
      {"corner to corner: their boxes overlap, they do not", {Discs{{{0, 0}, 1}, {{1.5, 1.5}, 1}}}},
      {"the list is not sorted", {Discs{{{5, 0}, 1}, {{0, 0}, 1}, {{4, 0}, 1}, {{1, 0}, 1}}}},
      {"a large one over three small ones",
       {Discs{{{0, 0}, 5}, {{-3, 0}, 0.5}, {{0, 0}, 0.5}, {{3, 0}, 0.5}}}},
      {"a large one, listed last", {Discs{{{-3, 0}, 0.5}, {{0, 0}, 0.5}, {{3, 0}, 0.5}, {{0, 0}, 5}}}},
      {"between two that overlap another one begins, far above",
       {Discs{{{0, 0}, 2}, {{1, 9}, 1}, {{3, 0}, 2}}}},
      {"none", {Discs{}}},
      {"one alone", {Discs{{{0, 0}, 1}}}},
  };
  probes.random = [](Chance& chance) {
    Discs discs;
    for (std::size_t n = 2 + chance.below(12); n > 0; --n)
      discs.push_back(
          {chance.vector2(6), chance.below(5) == 0 ? chance.number(2, 5) : chance.number(0.25, 1.5)});
    return std::tuple{discs};
  };
  probes.allowed = [](const auto& input) {
    for (const Disc& disc : std::get<0>(input))
      if (!(disc.radius > 0.01)) return false;
    return true;
  };
  probes.judge = judge;
  probes.any_order = true;
  probes.along = {"x of the first disc (number in the first pair)", -6, 6, [](auto& input, double at) {
                    if (!std::get<0>(input).empty()) std::get<0>(input)[0].centre.x = at;
                  }};
  return probes;
}
