#include "first_contact/sweep/sphere_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/accurate_cross.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"

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
///
/// Its units of length and of time are the caller's, or powers of two of them, where squares of squares would
/// leave the range of double.
struct RelativeMotion {
  RelativeMotion(const Moving<Sphere>& p, const Moving<Sphere>& q)
      : w(p.shape.center, q.shape.center),
        u(p.displacement, q.displacement),
        d(p.shape.radius + q.shape.radius) {
    const double size = std::max(largest(w.rounded), d), speed = largest(u.rounded);
    const bool ordinary = is_ordinary(size) && is_ordinary(speed) && (d == 0 || is_ordinary(d));
    if (!ordinary && speed > 0) choose_units(unit_scale(size), unit_scale(speed));
    moment = accurate_cross(w.rounded, u.rounded) + (w.rest.cross(u.rounded) + w.rounded.cross(u.rest));
    if (!ordinary) zoom = unit_scale(std::max(largest(moment), d));
  }

  /// w + t u, rounded as if it had been computed exactly.
  Vector position(double time) const {
    const double t = pace == 1 ? time : time / pace;
    const Vector sum = u.rounded.binaryExpr(w.rounded, [t](double v, double p) { return fused(t, v, p); });
    return sum + (w.rest + t * u.rest);
  }

  /// (u d)^2 - |w x u|^2, times the square of the zoom.
  double discriminant() const {
    return first_contact::discriminant<double>(u.rounded, zoom * moment, zoom * d);
  }

  Difference w, u;
  double d;
  Vector moment;    // w x u: where rounding of w or u would hurt, if they are long and nearly parallel
  double pace = 1;  // the unit of time
  double zoom = 1;  // what d and the closest approach are multiplied by, lest their squares vanish beside w^2

 private:
  void choose_units(double length, double speed) {
    length = std::min(length, speed * 0x1p1000);  // so that the pace stays a double
    speed = std::min(speed, length * 0x1p1000);
    for (Vector* v : {&w.rounded, &w.rest}) *v *= length;
    for (Vector* v : {&u.rounded, &u.rest}) *v *= speed;
    d *= length;
    pace = speed / length;
  }
};

bool is_zero(const Vector& v) { return (v.array() == 0).all(); }

/// The unit normal from Q to P when P comes in: the vector to the closest approach, u x (w x u) / u^2, less
/// half the way that P then has gone inside, sqrt(D) / u^2 u. Its error does not grow with the distance that
/// P came from.
Vector normal_at_contact(const RelativeMotion& seen) {
  const Vector& u = seen.u.rounded;
  const double D = std::max(0.0, seen.discriminant());
  const Vector across = u.cross(seen.zoom * seen.moment) - std::sqrt(D) * u;
  return normalized(is_zero(across) ? Vector(-u) : across);  // two points: against the motion
}

/// When |w + t u| = d, in the caller's unit of time; w is where P is at t = 0.
std::optional<ContactTimes<double>> times_of(const RelativeMotion& seen, const Vector& w) {
  const Vector& u = seen.u.rounded;
  auto times = contact_times(w, u, seen.moment, seen.d);
  if (seen.zoom != 1) {  // the same formulas, with the discriminant as seen from nearer
    const double a = squared_norm(u), b = dot(w, u), c = squared_norm(w) - seen.d * seen.d;
    const double D = seen.discriminant();
    if (!(a > 0) || !(D >= 0)) return std::nullopt;
    const double sum = -b + std::copysign(std::sqrt(D) / seen.zoom, -b);
    times = sum == 0 ? ContactTimes<double>{0, 0}
                     : ContactTimes<double>{std::min(c / sum, sum / a), std::max(c / sum, sum / a)};
  }
  if (times) times->begin *= seen.pace, times->end *= seen.pace;
  return times;
}

/// The contact with its point, the paper's C = P(t) + r_P N; the paper's N points from P to Q, ours to P.
Contact contact(const Moving<Sphere>& p, double t, const Vector& normal) {
  const Point center = p.shape.center + t * p.displacement;
  return {t, only(center - p.shape.radius * normal), normal, Feature::face};
}

}  // namespace

bool overlap(const Sphere& p, const Sphere& q) { return within(p.center - q.center, p.radius + q.radius); }

std::optional<ContactTimes<double>> contact_interval(const Moving<Sphere>& p, const Moving<Sphere>& q) {
  const RelativeMotion seen(p, q);
  return times_of(seen, seen.w.rounded);
}

//! [sweep_sphere_sphere]
std::optional<Contact> sweep(const Moving<Sphere>& p, const Moving<Sphere>& q, const Interval& when) {
  const RelativeMotion seen(p, q);
  const Vector& u = seen.u.rounded;
  const Vector w = seen.position(when.first);
  if (is_zero(u)) return std::nullopt;                            // at rest to each other
  if (is_zero(w)) return contact(p, when.first, -normalized(u));  // concentric: against the motion
  if (!(dot(w, u) < 0)) return std::nullopt;                      // sliding along, or leaving
  if (within(w, seen.d))                                          // overlapping and going deeper: now
    return contact(p, when.first, normalized(w));

  const auto times = times_of(seen, w);  // counted from t_m
  if (!times) return std::nullopt;       // passing each other
  const double t = when.first + times->begin;
  if (!(t <= when.last)) return std::nullopt;  // not within this interval
  return contact(p, t, normal_at_contact(seen));
}
//! [sweep_sphere_sphere]

std::optional<Contact> sweep(const Moving<Sphere>& p, const Sphere& q) {
  return sweep(p, Moving<Sphere>{q, Vector::Zero()});
}

}  // namespace first_contact
