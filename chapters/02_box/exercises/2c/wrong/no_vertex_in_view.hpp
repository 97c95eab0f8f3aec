// Looks like: a box is rejected when none of its eight vertices is in view.
// Ask: the camera stands in the middle of a hall. Which vertex of the hall does it see?
#include "task.hpp"

bool rejected(const std::array<Plane, 6>& frustum, const Box& box) {
  for (const double a : {-0.5, 0.5})
    for (const double b : {-0.5, 0.5})
      for (const double c : {-0.5, 0.5}) {
        const Point vertex = box.Q + a * box.R + b * box.S + c * box.T;
        if (std::all_of(frustum.begin(), frustum.end(), [&](const Plane& E) { return dot(E, vertex) >= 0; }))
          return false;
      }
  return true;
}
