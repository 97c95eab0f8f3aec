// Looks like: all meetings are foreseen at the beginning, and kept: one of the two had already been turned
// when its meeting came.
// Ask: disc 1 was struck away. Is it still where disc 2 expects it?
#include "task.hpp"

std::vector<Impact> impacts(std::vector<Disc> discs, double until) {
  std::vector<Impact> list;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      if (const auto t = meeting(discs[i], discs[j]); t && *t < until)
        list.push_back({*t, static_cast<int>(i), static_cast<int>(j)});
  std::sort(list.begin(), list.end(), [](const Impact& a, const Impact& b) { return a.time < b.time; });
  return list;
}
