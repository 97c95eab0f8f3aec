// Looks like: the radius of the ball around the box, the same in all directions.
// Ask: a flat brick lies on the floor. How high is its centre?
#include "task.hpp"

double effective_radius(const Box& box, Vector N) {
  return 0.5 * std::sqrt(dot(box.R, box.R) + dot(box.S, box.S) + dot(box.T, box.T)) * norm(N);
}
