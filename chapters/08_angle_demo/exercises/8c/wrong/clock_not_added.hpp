// Looks like: each time is counted from the impact before it, not from 0.
// Ask: the first impact is at 2, the next one 3 later. What time is it then?
#include "task.hpp"

std::vector<Impact> impacts(std::vector<Disc> discs, double until) {
  std::vector<Impact> list;
  for (double now = 0; list.size() < 60;) {
    std::optional<Impact> next;
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t j = i + 1; j < discs.size(); ++j)
        if (const auto t = meeting(discs[i], discs[j]); t && now + *t < until && (!next || *t < next->time))
          next = {*t, static_cast<int>(i), static_cast<int>(j)};
    if (!next) break;
    now += next->time;
    for (Disc& disc : discs) disc.place = disc.place + next->time * disc.velocity;
    collide(discs[static_cast<std::size_t>(next->first)], discs[static_cast<std::size_t>(next->second)]);
    list.push_back(*next);
  }
  return list;
}
