// Looks like: the time is counted from `from`: it is not added again at the end.
// Ask: the span begins at 3, and they touch 4 later. What is t?
#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector w = P + from * Vp - Q - from * Vq, u = Vp - Vq;
  const double uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (wu >= 0) return {};
  if (dot(w, w) <= d * d) return 0;
  if (under < 0) return {};
  const double t = (-wu - std::sqrt(under)) / uu;
  if (from + t > to) return {};
  return t;
}
