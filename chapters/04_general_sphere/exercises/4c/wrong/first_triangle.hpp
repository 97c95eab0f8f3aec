// Looks like: the first triangle of the list that is hit, not the first in time.
// Ask: turn the list round. Does the ball touch something else then?
// Seen in: PhysX (NVIDIA-Omniverse/PhysX#505): a grazed edge hid the wall, and the ball passed through
#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  for (const Triangle& each : soup) {
    const auto& [a, b, c] = each;
    std::optional<double> first;
    for (const auto& t : {touch_face(each, S0, V, r), touch_edge(a, b, S0, V, r), touch_edge(b, c, S0, V, r),
                          touch_edge(c, a, S0, V, r), touch_vertex(a, S0, V, r), touch_vertex(b, S0, V, r),
                          touch_vertex(c, S0, V, r)})
      if (t && (!first || *t < *first)) first = t;
    if (first) return first;
  }
  return {};
}
