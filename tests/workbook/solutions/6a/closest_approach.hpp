#include "task.hpp"

std::optional<double> first_contact(Point P, Vector Vp, Point Q, Vector Vq, double d, double from,
                                    double to) {
  const Vector u = Vp - Vq, begin = P - Q + from * u;
  const double speed = norm(u), way = -dot(begin, u) / speed;
  if (!(way > 0)) return {};
  if (dot(begin, begin) <= d * d) return from;
  const double beside = norm(cross(begin, u)) / speed;
  if (beside > d) return {};
  const double t = from + (way - std::sqrt(d * d - beside * beside)) / speed;
  return t <= to ? std::optional(t) : std::nullopt;
}
