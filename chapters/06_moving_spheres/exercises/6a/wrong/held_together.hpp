// Looks like: whatever overlaps at the beginning is in contact, also when it parts: the two are held
// together.
// Ask: two balls overlap and fly apart. What will an impact do to them?
// Seen in: Ten Minute Physics, handleBallCollision; Game Physics in One Weekend, ResolveContact; Parry
// (dimforge/parry#206)
#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector w = P + from * Vp - Q - from * Vq, u = Vp - Vq;
  if (dot(w, w) <= d * d) return from;
  const double uu = dot(u, u), wu = dot(w, u), under = wu * wu - uu * (dot(w, w) - d * d);
  if (wu >= 0 || under < 0) return {};
  const double t = from + (-wu - std::sqrt(under)) / uu;
  if (t > to) return {};
  return t;
}
