// Looks like: only faces are asked: the ball falls past edges and vertices.
// Ask: the ball comes down on the ridge of a blade. Which face does it touch?
#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  std::optional<double> first;
  for (const Triangle& each : soup)
    if (const auto t = touch_face(each, S0, V, r); t && (!first || *t < *first)) first = t;
  return first;
}
