// Looks like: the edge from c back to a is left out.
// Ask: how many edges has a triangle?
#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  std::optional<double> first;
  for (const Triangle& each : soup) {
    const auto& [a, b, c] = each;
    for (const auto& t : {touch_face(each, S0, V, r), touch_edge(a, b, S0, V, r), touch_edge(b, c, S0, V, r),
                          touch_vertex(a, S0, V, r), touch_vertex(b, S0, V, r), touch_vertex(c, S0, V, r)})
      if (t && (!first || *t < *first)) first = t;
  }
  return first;
}
