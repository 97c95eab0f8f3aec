// Looks like: a contact after the end of the span counts.
// Ask: `to` is 1, and they touch at 7/4. Does that belong to this picture of the film?
#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector w = P + from * Vp - Q - from * Vq, u = Vp - Vq;
  const double uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (wu >= 0) return {};
  if (dot(w, w) <= d * d) return from;
  if (under < 0) return {};
  return from + (-wu - std::sqrt(under)) / uu + 0 * to;
}
