// Looks like: once a face is hit, edges and vertices are left out, as the paper does: right for one convex
// solid, and not for a soup.
// Ask: a blade stands on a floor. What does the ball touch first, the tip or the floor below it?
// Seen in: the paper, 2.1
#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  std::optional<double> first;
  const auto take = [&](std::optional<double> t) {
    if (t && (!first || *t < *first)) first = t;
  };
  for (const Triangle& each : soup) take(touch_face(each, S0, V, r));
  if (first) return first;
  for (const auto& [a, b, c] : soup)
    take(touch_edge(a, b, S0, V, r)), take(touch_edge(b, c, S0, V, r)), take(touch_edge(c, a, S0, V, r));
  if (first) return first;
  for (const auto& [a, b, c] : soup)
    take(touch_vertex(a, S0, V, r)), take(touch_vertex(b, S0, V, r)), take(touch_vertex(c, S0, V, r));
  return first;
}
