// Looks like: the list ends after the first impact.
// Ask: what does the struck disc do next?
#include "task.hpp"

std::vector<Impact> impacts(std::vector<Disc> discs, double until) {
  std::optional<Impact> first;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      if (const auto t = meeting(discs[i], discs[j]); t && *t < until && (!first || *t < first->time))
        first = {*t, static_cast<int>(i), static_cast<int>(j)};
  if (!first) return {};
  return {*first};
}
