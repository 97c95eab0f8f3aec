// Looks like: a disc that has had an impact has no other: what was struck is left out afterwards.
// Ask: a ball of billiards is struck, and strikes another one. How many impacts has it had?
#include "task.hpp"

std::vector<Impact> impacts(std::vector<Disc> discs, double until) {
  std::vector<Impact> list;
  std::vector<bool> had(discs.size());
  for (double now = 0; list.size() < 60;) {
    std::optional<Impact> next;
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t j = i + 1; j < discs.size(); ++j)
        if (const auto t = meeting(discs[i], discs[j]);
            t && !had[i] && !had[j] && now + *t < until && (!next || *t < next->time))
          next = {*t, static_cast<int>(i), static_cast<int>(j)};
    if (!next) break;
    now += next->time;
    for (Disc& disc : discs) disc.place = disc.place + next->time * disc.velocity;
    had[static_cast<std::size_t>(next->first)] = had[static_cast<std::size_t>(next->second)] = true;
    list.push_back({now, next->first, next->second});
  }
  return list;
}
