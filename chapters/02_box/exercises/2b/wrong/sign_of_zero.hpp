// Looks like: the sign of 0 is 0: a level axis adds nothing, and the point lies in the middle of an edge or a
// face.
// Ask: is there a vertex of the box where your point is?
#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  Point point = box.Q;
  for (const Vector& axis : {box.R, box.S, box.T}) {
    const double slope = dot(axis, N);
    if (std::abs(slope) <= 16 * std::numeric_limits<double>::epsilon() * norm(axis)) continue;
    point = point - (slope > 0 ? 0.5 : -0.5) * axis;
  }
  return {point};
}
