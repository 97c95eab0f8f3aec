// Looks like: the two are turned before they have been moved to where they meet: along the wrong normal.
// Ask: where are their centres when they touch?
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
    std::vector<Vector2> old;
    for (const Disc& disc : discs) old.push_back(disc.velocity);
    collide(discs[static_cast<std::size_t>(next->first)], discs[static_cast<std::size_t>(next->second)]);
    for (std::size_t i = 0; i < discs.size(); ++i) discs[i].place = discs[i].place + next->time * old[i];
    list.push_back({now, next->first, next->second});
  }
  return list;
}
