// Looks like: the ball is looked at in the last picture only, and where it touches there, the answer is 1.
// Ask: at the end the ball is deep in the floor. When was it that it touched?
// Seen in: p5.play (code-dot-org/p5.play, PR 18)
#include "task.hpp"

std::optional<double> touch_time(Plane E, Point S0, Vector V, double r) {
  if (dot(E, S0 + V) > r * norm(E.N)) return {};
  return 1;
}
