#include "task.hpp"

// The first t in [0, 1] at which the ball touches any triangle of the soup, by a face, an edge or a vertex;
// else {}.
std::optional<double> touch_soup(const std::vector<Triangle>& soup, Point S0, Vector V, double r) {
  return {};
}
