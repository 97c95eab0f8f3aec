// Looks like: faces and vertices are asked, but no edges.
// Ask: the ball comes down on the middle of a ridge, far from both of its ends. What does it touch?
#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  std::optional<double> first;
  for (const Triangle& each : soup) {
    const auto& [a, b, c] = each;
    for (const auto& t : {touch_face(each, S0, V, r), touch_vertex(a, S0, V, r), touch_vertex(b, S0, V, r),
                          touch_vertex(c, S0, V, r)})
      if (t && (!first || *t < *first)) first = t;
  }
  return first;
}
