#pragma once
// An oracle with 50 digits that shares no formula with the library: the distance from a triangle falls and
// then rises along a straight path, so that its minimum and its crossings are found by bisection.
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>

#include "first_contact/geometry/triangle.hpp"

namespace oracle {

using Real = boost::multiprecision::cpp_bin_float_50;
using Exact = std::array<Real, 3>;

inline Exact exact(const first_contact::Vector& v) { return {Real(v.x()), Real(v.y()), Real(v.z())}; }
inline Real dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Exact sum(const Exact& a, const Real& s, const Exact& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline Exact difference(const Exact& a, const Exact& b) { return sum(a, Real(-1), b); }

/// A triangle and the point of it that is nearest to another point.
class ExactTriangle {
 public:
  explicit ExactTriangle(const first_contact::Triangle& t) : corners_{exact(t.a), exact(t.b), exact(t.c)} {}

  Exact nearest(const Exact& p) const {
    Exact best = corners_[0];
    for (std::size_t i = 0; i < 3; ++i) keep(best, on_side(p, corners_[i], corners_[(i + 1) % 3]), p);
    // Inside: solve for p - a = u (b - a) + v (c - a) + something at right angles to both.
    const Exact f = difference(corners_[1], corners_[0]), g = difference(corners_[2], corners_[0]);
    const Exact h = difference(p, corners_[0]);
    const Real ff = dot(f, f), fg = dot(f, g), gg = dot(g, g), det = ff * gg - fg * fg;
    if (det > 0) {
      const Real u = (gg * dot(f, h) - fg * dot(g, h)) / det, v = (ff * dot(g, h) - fg * dot(f, h)) / det;
      if (u >= 0 && v >= 0 && u + v <= 1) keep(best, sum(sum(corners_[0], u, f), v, g), p);
    }
    return best;
  }

 private:
  static Exact on_side(const Exact& p, const Exact& a, const Exact& b) {
    const Exact e = difference(b, a);
    const Real ee = dot(e, e);
    if (ee == 0) return a;
    const Real k = dot(difference(p, a), e) / ee;
    return sum(a, k < 0 ? Real(0) : k > 1 ? Real(1) : k, e);
  }
  static void keep(Exact& best, const Exact& other, const Exact& p) {
    const Exact x = difference(best, p), y = difference(other, p);
    if (dot(y, y) < dot(x, x)) best = other;
  }

  std::array<Exact, 3> corners_;
};

/// The distance of a moving point from a triangle.
class Approach {
 public:
  Approach(const first_contact::Triangle& triangle, const first_contact::Point& start,
           const first_contact::Vector& displacement)
      : triangle_(triangle),
        start_(exact(start)),
        displacement_(exact(displacement)),
        closest_(find_closest()) {}

  Real distance(const Real& t) const {
    const Exact w = offset(t);
    return sqrt(dot(w, w));
  }
  Real least_distance() const { return distance(closest_); }

  /// The first t in [0, 1] at which the distance is at most r; 0 if it is so at the start.
  std::optional<Real> first_time(const Real& r) const {
    if (r < 0 || least_distance() > r) return std::nullopt;
    if (distance(Real(0)) <= r) return Real(0);
    return bisect(Real(0), closest_, [&](const Real& t) { return distance(t) <= r; });
  }

 private:
  Exact offset(const Real& t) const {
    const Exact p = sum(start_, t, displacement_);
    return difference(p, triangle_.nearest(p));
  }
  Real find_closest() const {
    const auto rising = [&](const Real& t) { return dot(offset(t), displacement_) >= 0; };
    if (rising(Real(0))) return Real(0);
    if (!rising(Real(1))) return Real(1);
    return bisect(Real(0), Real(1), rising);
  }
  /// Where a condition that is false at `from` and true at `to` turns true.
  template <class Condition>
  static Real bisect(Real from, Real to, const Condition& condition) {
    for (int i = 0; i < 110; ++i) {
      const Real middle = (from + to) / 2;
      (condition(middle) ? to : from) = middle;
    }
    return to;
  }

  ExactTriangle triangle_;
  Exact start_, displacement_;
  Real closest_;
};

}  // namespace oracle
