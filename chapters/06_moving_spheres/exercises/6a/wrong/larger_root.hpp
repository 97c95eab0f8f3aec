// Looks like: the larger root: that is when they part again.
// Ask: which of the two roots comes first, that with the plus or that with the minus?
#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector w = P - Q, u = Vp - Vq;
  const double uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  const Vector begin = w + from * u;
  if (dot(begin, u) >= 0) return {};
  if (dot(begin, begin) <= d * d) return from;
  if (under < 0) return {};
  const double t = (-wu + std::sqrt(under)) / uu;
  if (t > to) return {};
  return t;
}
