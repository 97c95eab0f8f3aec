// Looks like: whatever overlaps at the start is in contact at 0, also when it is on its way out.
// Ask: your ball was pushed a little into the wall and now flies away from it. When will your sweep let it
// go?
// Seen in: Box2D (erincatto/box2d#50); noonat/intersect, where a box that parts is held with a normal into
// the floor
#include "task.hpp"

std::optional<double> first_contact(Plane E, Point S0, Vector V, double r) {
  const double side = dot(E, S0) < 0 ? -1 : 1, height = side * dot(E, S0), toward = side * dot(E.N, V);
  if (height <= r) return 0;
  if (toward >= 0) return {};
  const double t = (r - height) / toward;
  if (t > 1) return {};
  return t;
}
