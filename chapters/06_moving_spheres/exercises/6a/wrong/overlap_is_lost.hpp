// Looks like: a root before the beginning is no contact, also when the two overlap and go deeper: they fall
// through each other.
// Ask: the smaller root lies before `from`, the larger one after it. Where are the balls at `from`?
#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector w = P + from * Vp - Q - from * Vq, u = Vp - Vq;
  const double uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (wu >= 0 || under < 0) return {};
  const double t = (-wu - std::sqrt(under)) / uu;
  if (t < 0 || from + t > to) return {};
  return from + t;
}
