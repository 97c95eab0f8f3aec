// Looks like: what leads away from the wall is taken as well: the ball is glued to it.
// Ask: the ball jumps up from the floor. What is left of its jump?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) { return w - dot(w, N) / dot(N, N) * N; }
