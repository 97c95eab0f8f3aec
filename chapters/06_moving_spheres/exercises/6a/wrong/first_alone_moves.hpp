// Looks like: the second ball is taken to rest.
// Ask: where does Vq stand in your code?
#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector u = Vp + 0 * Vq, w = P - Q + from * u;
  const double uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (wu >= 0) return {};
  if (dot(w, w) <= d * d) return from;
  if (under < 0) return {};
  const double t = from + (-wu - std::sqrt(under)) / uu;
  if (t > to) return {};
  return t;
}
