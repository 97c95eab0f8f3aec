#include "first_contact/sweep/sphere_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/accurate_cross.hpp"
#include "first_contact/geometry/products.hpp"

namespace first_contact {

namespace {

/// x - y, and what its rounding left out (Knuth, The Art of Computer Programming 2, section 4.2.2, theorem
/// B).
struct Difference {
  Difference(const Vector& x, const Vector& y) : rounded(x - y) {
    const Vector y_seen = x - rounded;
    rest = (x - (rounded + y_seen)) + (y_seen - y);
  }

  Vector rounded, rest;
};

/// P as seen from Q: Q's centre stays at the origin, P's centre moves as w + t u, and they touch where |w + t
/// u| = d.
struct RelativeMotion {
  RelativeMotion(const Moving<Sphere>& p, const Moving<Sphere>& q)
      : w(p.shape.center, q.shape.center),
        u(p.displacement, q.displacement),
        d(p.shape.radius + q.shape.radius),
        moment(accurate_cross(w.rounded, u.rounded) + (w.rest.cross(u.rounded) + w.rounded.cross(u.rest))) {}

  /// w + t u, rounded as if it had been computed exactly.
  Vector position(double t) const {
    const Vector sum = u.rounded.binaryExpr(w.rounded, [t](double v, double p) { return fused(t, v, p); });
    return sum + (w.rest + t * u.rest);
  }

  Difference w, u;
  double d;
  Vector moment;  // w x u: where rounding of w or u would hurt, if they are long and nearly parallel
};

bool is_zero(const Vector& v) { return (v.array() == 0).all(); }

/// The unit normal from Q to P when P comes in: the vector to the closest approach, u x (w x u) / u^2, less
/// half the way that P then has gone inside, sqrt(D) / u^2 u. Its error does not grow with the distance that
/// P came from.
Vector normal_at_contact(const RelativeMotion& seen) {
  const Vector& u = seen.u.rounded;
  const double D = std::max(0.0, discriminant(u, seen.moment, seen.d));
  const Vector across = u.cross(seen.moment) - std::sqrt(D) * u;
  return normalized(is_zero(across) ? Vector(-u) : across);  // two points: against the motion
}

/// The contact with its point, the paper's C = P(t) + r_P N; the paper's N points from P to Q, ours to P.
Contact contact(const Moving<Sphere>& p, double t, const Vector& normal) {
  const Point center = p.shape.center + t * p.displacement;
  return {t, only(center - p.shape.radius * normal), normal, Feature::face};
}

}  // namespace

bool overlap(const Sphere& p, const Sphere& q) {
  const double d = p.radius + q.radius;
  return squared_norm(p.center - q.center) <= d * d;
}

std::optional<ContactTimes<double>> contact_interval(const Moving<Sphere>& p, const Moving<Sphere>& q) {
  const RelativeMotion seen(p, q);
  return contact_times(seen.w.rounded, seen.u.rounded, seen.moment, seen.d);
}

//! [sweep_sphere_sphere]
std::optional<Contact> sweep(const Moving<Sphere>& p, const Moving<Sphere>& q, const Interval& when) {
  const RelativeMotion seen(p, q);
  const Vector& u = seen.u.rounded;
  const Vector w = seen.position(when.first);
  if (is_zero(u)) return std::nullopt;                            // at rest to each other
  if (is_zero(w)) return contact(p, when.first, -normalized(u));  // concentric: against the motion
  if (!(dot(w, u) < 0)) return std::nullopt;                      // sliding along, or leaving
  if (squared_norm(w) <= seen.d * seen.d)                         // overlapping and going deeper: now
    return contact(p, when.first, normalized(w));

  const auto times = contact_times(w, u, seen.moment, seen.d);  // counted from t_m
  if (!times) return std::nullopt;                              // passing each other
  const double t = when.first + times->begin;
  if (!(t <= when.last)) return std::nullopt;  // not within this interval
  return contact(p, t, normal_at_contact(seen));
}
//! [sweep_sphere_sphere]

std::optional<Contact> sweep(const Moving<Sphere>& p, const Sphere& q) {
  return sweep(p, Moving<Sphere>{q, Vector::Zero()});
}

}  // namespace first_contact
