#include "task.hpp"

std::optional<double> touch_edge(Point a, Point b, Point S0, Vector V, double r) {
  const Vector e = b - a, m = S0 - a;
  const double ee = dot(e, e), me = dot(m, e), ve = dot(V, e);
  const double A = ee * dot(V, V) - ve * ve, B = ee * dot(m, V) - me * ve,
               C = ee * (dot(m, m) - r * r) - me * me;
  if (B >= 0 || B * B - A * C < 0) return {};
  const double t = C / (-B + std::sqrt(B * B - A * C));
  if (t > 1 || me + t * ve < 0 || me + t * ve > ee) return {};
  return t;
}
