// Looks like: the first pair of the list that will meet, not the pair that meets first.
// Ask: discs 0 and 1 meet at 5, discs 2 and 3 at 1. Which comes first?
#include "task.hpp"

std::vector<Impact> impacts(std::vector<Disc> discs, double until) {
  std::vector<Impact> list;
  for (double now = 0; list.size() < 60;) {
    std::optional<Impact> next;
    for (std::size_t i = 0; i < discs.size() && !next; ++i)
      for (std::size_t j = i + 1; j < discs.size() && !next; ++j)
        if (const auto t = meeting(discs[i], discs[j]); t && now + *t < until)
          next = {*t, static_cast<int>(i), static_cast<int>(j)};
    if (!next) break;
    now += next->time;
    for (Disc& disc : discs) disc.place = disc.place + next->time * disc.velocity;
    collide(discs[static_cast<std::size_t>(next->first)], discs[static_cast<std::size_t>(next->second)]);
    list.push_back({now, next->first, next->second});
  }
  return list;
}
