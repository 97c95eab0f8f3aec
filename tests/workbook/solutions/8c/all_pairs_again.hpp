#include "task.hpp"

std::vector<Impact> impacts(std::vector<Disc> discs, double until) {
  std::vector<Impact> list;
  for (double now = 0;;) {
    Impact next{until - now, -1, -1};
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t j = i + 1; j < discs.size(); ++j)
        if (const auto t = meeting(discs[i], discs[j]); t && *t < next.time)
          next = {*t, static_cast<int>(i), static_cast<int>(j)};
    if (next.first < 0) return list;
    for (Disc& disc : discs) disc.place = disc.place + next.time * disc.velocity;
    collide(discs[static_cast<std::size_t>(next.first)], discs[static_cast<std::size_t>(next.second)]);
    list.push_back({now += next.time, next.first, next.second});
  }
}
