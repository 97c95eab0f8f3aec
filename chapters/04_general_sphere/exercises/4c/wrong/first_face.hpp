// Looks like: the first face of the list that is hit; no edges, no vertices, and not the earliest.
// Ask: turn the list round. Does the ball touch something else then? And what of the rims of the faces?
#include "task.hpp"

std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  for (const Triangle& each : soup)
    if (const auto t = touch_face(each, S0, V, r)) return t;
  return {};
}
