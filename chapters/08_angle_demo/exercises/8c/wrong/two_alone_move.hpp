// Looks like: only the two that collide are moved to the time of their impact; all others stay where they
// were.
// Ask: where are the other discs meanwhile?
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
    Disc &a = discs[static_cast<std::size_t>(next->first)],
         &b = discs[static_cast<std::size_t>(next->second)];
    a.place = a.place + next->time * a.velocity, b.place = b.place + next->time * b.velocity;
    collide(a, b);
    list.push_back({now, next->first, next->second});
  }
  return list;
}
