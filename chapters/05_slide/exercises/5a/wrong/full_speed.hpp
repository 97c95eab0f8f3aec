// Looks like: what is left is made as long as w was: the ball does not lose what the wall takes.
// Ask: it runs nearly straight into the wall, a trifle to the left. How fast does it go to the left, and why?
#include "task.hpp"

Vector slide_along(Vector w, Vector N) {
  if (dot(w, N) >= 0) return w;
  const Vector left = w - dot(w, N) / dot(N, N) * N;
  if (norm(left) < 1e-12 * norm(w)) return left;
  return norm(w) / norm(left) * left;
}
