#include "task.hpp"

static double when(const std::vector<Disc>& discs, std::size_t i, std::size_t j, double now) {
  const auto t = i == j ? std::nullopt : meeting(discs[i], discs[j]);
  return t ? now + *t : std::numeric_limits<double>::infinity();
}

std::vector<Impact> impacts(std::vector<Disc> discs, double until) {
  const std::size_t n = discs.size();
  std::vector<std::vector<double>> times(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j) times[i][j] = when(discs, i, j, 0);
  std::vector<Impact> list;
  for (double now = 0;;) {
    std::size_t a = 0, b = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        if (a == b || times[i][j] < times[a][b]) a = i, b = j;
    if (a == b || times[a][b] >= until) return list;
    for (Disc& disc : discs) disc.place = disc.place + (times[a][b] - now) * disc.velocity;
    now = times[a][b];
    list.push_back({now, static_cast<int>(a), static_cast<int>(b)});
    collide(discs[a], discs[b]);
    for (std::size_t i = 0; i < n; ++i)
      for (const std::size_t struck : {a, b})
        times[std::min(i, struck)][std::max(i, struck)] = when(discs, i, struck, now);
  }
}
