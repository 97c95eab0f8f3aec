#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  std::vector<double> times;
  const auto note = [&](std::optional<double> t) { times.push_back(t.value_or(2)); };
  for (const auto& [a, b, c] : soup) {
    note(touch_face({a, b, c}, S0, V, r));
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}})
      note(touch_edge(p, q, S0, V, r)), note(touch_vertex(p, S0, V, r));
  }
  const double first = times.empty() ? 2 : *std::min_element(times.begin(), times.end());
  if (first > 1) return {};
  return first;
}
