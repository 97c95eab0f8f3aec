// Looks like: for each triangle the face, else an edge, else a vertex; the earliest of all triangles.
// Ask: a thin triangle is met edge on. Can its edge be touched before its face?
#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  std::optional<double> first;
  for (const auto& each : soup) {
    const auto& [a, b, c] = each;
    auto t = touch_face(each, S0, V, r);
    for (const auto& other :
         {touch_edge(a, b, S0, V, r), touch_edge(b, c, S0, V, r), touch_edge(c, a, S0, V, r),
          touch_vertex(a, S0, V, r), touch_vertex(b, S0, V, r), touch_vertex(c, S0, V, r)})
      if (!t) t = other;
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}
