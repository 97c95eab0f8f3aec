#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "first_contact/trees/plain_bvh.hpp"

/// \file
/// What the fast sweep is measured against: the plain tree with the sweep of a textbook, in doubles. It finds
/// the time and the triangle and nothing else, and its tolerances are none.

namespace yardstick {

using namespace first_contact;

inline constexpr double never = std::numeric_limits<double>::infinity();

/// First root of a t^2 + 2 b t + c = 0 that is not negative, the sphere entering.
inline double first_root(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0) || a == 0) return never;
  const double t = (-b - std::sqrt(discriminant)) / a;
  return t >= 0 ? t : never;
}

/// When a moving sphere touches a triangle (Ericson, 5.5.6; Fauerby 2003): 0 if it does so at the start.
inline double sweep(const Moving<Sphere>& moving, const Triangle& triangle) {
  const auto& [s, r] = moving.shape;
  const Vector& v = moving.displacement;
  const Point corner[3] = {triangle.a, triangle.b, triangle.c};
  const Vector n = triangle.area_vector();
  const double n2 = n.squaredNorm();
  double first = never;

  const auto inside = [&](const Point& p) {
    for (int i = 0; i < 3; ++i)
      if ((corner[(i + 1) % 3] - corner[i]).cross(p - corner[i]).dot(n) < 0) return false;
    return true;
  };
  if (n2 > 0) {
    const double length = std::sqrt(n2), height = n.dot(s - corner[0]), toward = n.dot(v);
    if (std::abs(height) <= r * length && inside(s)) return 0;
    const double t = (std::copysign(r * length, height) - height) / toward;
    if (height * toward < 0 && t >= 0 && inside(s + t * v)) return t;
  }
  const double a = v.squaredNorm();
  for (int i = 0; i < 3; ++i) {
    const Vector m = s - corner[i], e = corner[(i + 1) % 3] - corner[i];
    const double mm = m.squaredNorm(), ee = e.squaredNorm(), me = m.dot(e), ve = v.dot(e), mv = m.dot(v);
    if (mm <= r * r) return 0;
    const double k = std::clamp(me / ee, 0.0, 1.0);
    if ((m - k * e).squaredNorm() <= r * r) return 0;
    first = std::min(first, first_root(a, mv, mm - r * r));
    const double t = first_root(a * ee - ve * ve, mv * ee - me * ve, (mm - r * r) * ee - me * me);
    const double along = me + t * ve;
    if (along >= 0 && along <= ee) first = std::min(first, t);
  }
  return first;
}

struct Hit {
  double time = never;
  std::uint32_t triangle = 0;
};

inline Hit sweep(const Moving<Sphere>& moving, const PlainBvh& tree) {
  Hit hit;
  tree.visit(moving, [&](std::uint32_t number) {
    const double t = sweep(moving, tree.mesh().triangle(number));
    if (t < hit.time) hit = {t, number};
    return hit.time;
  });
  if (hit.time > 1) hit.time = never;
  return hit;
}

}  // namespace yardstick
