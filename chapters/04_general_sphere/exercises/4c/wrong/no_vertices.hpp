// Looks like: faces and edges are asked, but no vertices.
// Ask: the ball comes down beside the tip of a blade. Between the ends of which edge does it touch?
#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  std::optional<double> first;
  for (const Triangle& each : soup) {
    const auto& [a, b, c] = each;
    for (const auto& t : {touch_face(each, S0, V, r), touch_edge(a, b, S0, V, r), touch_edge(b, c, S0, V, r),
                          touch_edge(c, a, S0, V, r)})
      if (t && (!first || *t < *first)) first = t;
  }
  return first;
}
