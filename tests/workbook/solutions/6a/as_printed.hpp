#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector w = P - Q, u = Vp - Vq, begin = w + from * u;
  if (dot(begin, u) >= 0) return {};
  if (norm(begin) <= d) return from;
  const double uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (under < 0) return {};
  const double t = (-wu - std::sqrt(under)) / uu;
  if (t > to) return {};
  return t;
}
