// Looks like: `until` is compared with the time to the next impact, not with the clock: impacts after the end
// are listed.
// Ask: the clock is at 9, and the next impact comes in 3. Is that before 10?
#include "task.hpp"

std::vector<Impact> impacts(std::vector<Disc> discs, double until) {
  std::vector<Impact> list;
  for (double now = 0; list.size() < 60;) {
    std::optional<Impact> next;
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t j = i + 1; j < discs.size(); ++j)
        if (const auto t = meeting(discs[i], discs[j]); t && *t < until && (!next || *t < next->time))
          next = {*t, static_cast<int>(i), static_cast<int>(j)};
    if (!next) break;
    now += next->time;
    for (Disc& disc : discs) disc.place = disc.place + next->time * disc.velocity;
    collide(discs[static_cast<std::size_t>(next->first)], discs[static_cast<std::size_t>(next->second)]);
    list.push_back({now, next->first, next->second});
  }
  return list;
}
