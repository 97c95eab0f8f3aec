// Looks like: twice the radius: the height of the whole box.
// Ask: the axes are as long as the box is. How far is it from the centre to the end of an axis?
#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  return std::abs(dot(box.R, N)) + std::abs(dot(box.S, N)) + std::abs(dot(box.T, N));
}
