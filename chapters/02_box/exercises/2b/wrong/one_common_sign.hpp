// Looks like: all three axes are taken with one sign: Q + (R + S + T)/2 or Q - (R + S + T)/2, two of the
// eight vertices.
// Ask: one axis points up and another down. Which end of each is the lower one?
// Seen in: the paper, 1.3
#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  const Vector half = 0.5 * (box.R + box.S + box.T);
  return {dot(half, N) > 0 ? box.Q - half : box.Q + half};
}
