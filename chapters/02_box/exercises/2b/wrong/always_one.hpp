// Looks like: one vertex always, also where the box lies on an edge or flat.
// Ask: where does a box lie that rests on one corner of its face? What will it do next?
#include "task.hpp"

std::vector<Point> lowest_points(const Box& box, Vector N) {
  Point point = box.Q;
  for (const Vector& axis : {box.R, box.S, box.T}) point = point - (dot(axis, N) < 0 ? -0.5 : 0.5) * axis;
  return {point};
}
