// Looks like: whether they come nearer is asked at t = 0, and not at `from`.
// Ask: w.u is negative at t = 0. Are they still coming nearer at `from`, or is the closest approach over?
#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector w = P - Q, u = Vp - Vq, now = w + from * u;
  const double uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (dot(now, now) < d * d) return wu < 0 ? std::optional(from) : std::nullopt;
  if (uu == 0 || under < 0) return {};
  const double t = (-wu - std::sqrt(under)) / uu;
  if (t < from || t > to) return {};
  return t;
}
