// Looks like: only the beginning and the end are looked at: they fly through each other in between.
// Ask: at the beginning they are 18 apart, at the end 18 again, on the other sides. Where were they in
// between?
// Seen in: p5.play (code-dot-org/p5.play, PR 18)
#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector begin = P + from * Vp - Q - from * Vq, end = P + to * Vp - Q - to * Vq, u = Vp - Vq;
  if (norm(begin) <= d && dot(begin, u) < 0) return from;
  if (norm(begin) > d && norm(end) <= d) return to;
  return {};
}
