// Looks like: both ends are free, each on a side of its own: the ball tunnels.
// Ask: at the start the distance is 2, at the end -3. Which distances did the centre have in between?
// Seen in: p5.play (code-dot-org/p5.play, PR 18)
#include "task.hpp"

bool surely_free(Plane E, double r, Point S0, Point S1) {
  return std::abs(dot(E, S0)) > r && std::abs(dot(E, S1)) > r;
}
