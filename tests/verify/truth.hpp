#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "first_contact/geometry/triangle.hpp"

/// \file
/// When does a moving sphere touch a triangle? Without any formula of the library, in any kind of number.
///
/// The distance from a triangle of a point that moves along a straight line is a convex function of time: it
/// first falls and then rises; it lies above its tangents and below its chords. So its tangents close in from
/// below on the time when it falls to r, its chords from above, and between them the truth cannot hide.

namespace truth {

template <class Real>
struct Vec {
  Real x, y, z;
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator*(const Real& s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
};
template <class Real>
Real dot(const Vec<Real>& a, const Vec<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Vec<Real> cross(const Vec<Real>& a, const Vec<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
Real norm(const Vec<Real>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
template <class Real>
Vec<Real> exact(const first_contact::Vector& v) {
  return {Real(v.x()), Real(v.y()), Real(v.z())};
}

/// A triangle, which may be degenerate, and the vector from a point to the nearest point of it.
///
/// The face has axes at right angles, f and g, from the corner with the largest angle, g made so twice:
/// however thin the triangle is, all is then right to the last digits of its longest side. With the products
/// of two slanting sides half of the digits would be lost, and with them half of the slivers.
template <class Real>
class Triangle {
 public:
  explicit Triangle(const first_contact::Triangle& t)
      : corners_{exact<Real>(t.a), exact<Real>(t.b), exact<Real>(t.c)} {
    const auto square_opposite = [&](std::size_t i) {
      const Vec<Real> side = corners_[(i + 2) % 3] - corners_[(i + 1) % 3];
      return dot(side, side);
    };
    for (std::size_t i = 1; i < 3; ++i)
      if (square_opposite(i) > square_opposite(origin_)) origin_ = i;
    f_ = corners_[(origin_ + 1) % 3] - corners_[origin_];
    g_ = corners_[(origin_ + 2) % 3] - corners_[origin_];
    ff_ = dot(f_, f_);
    if (!(ff_ > 0)) return;
    for (int i = 0; i < 2; ++i) {
      const Real along = dot(f_, g_) / ff_;
      g_ = g_ - along * f_;
      slant_ = slant_ + along;
    }
    gg_ = dot(g_, g_);
  }

  Vec<Real> from(const Vec<Real>& p) const {
    // Over the face: p - origin = x f + y g + something at right angles to both.
    if (gg_ > 0) {
      const Vec<Real> h = p - corners_[origin_];
      const Real x = dot(h, f_) / ff_, y = dot(h, g_) / gg_, u = x - y * slant_;
      if (u >= 0 && y >= 0 && u + y <= 1) return x * f_ + y * g_ - h;
    }
    Vec<Real> best = to_side(p, 0);
    Real least = dot(best, best);
    for (std::size_t i = 1; i < 3; ++i) {
      const Vec<Real> other = to_side(p, i);
      const Real square = dot(other, other);
      if (!(square < least)) continue;
      best = other;
      least = square;
    }
    return best;
  }

 private:
  Vec<Real> to_side(const Vec<Real>& p, std::size_t i) const {
    const Vec<Real>&a = corners_[i], e = corners_[(i + 1) % 3] - a, h = p - a;
    const Real ee = dot(e, e), along = dot(h, e);
    if (!(along > 0)) return Real(-1) * h;
    return (along < ee ? along / ee : Real(1)) * e - h;
  }

  std::array<Vec<Real>, 3> corners_;
  std::size_t origin_ = 0;
  Vec<Real> f_, g_;
  Real ff_, gg_ = 0, slant_ = 0;  // their squares; what g was made of besides itself, in terms of f
};

/// The distance of a moving point from a triangle.
template <class Real>
class Approach {
 public:
  Approach(const first_contact::Triangle& triangle, const first_contact::Point& start,
           const first_contact::Vector& displacement)
      : triangle_(triangle), start_(exact<Real>(start)), travel_(exact<Real>(displacement)) {}

  /// The nearest point, as seen from the moving one.
  Vec<Real> offset(const Real& t) const { return triangle_.from(start_ + t * travel_); }
  Vec<Real> point(const Real& t) const { return start_ + t * travel_ + offset(t); }
  Real distance(const Real& t) const { return norm(offset(t)); }

  /// The first t in [0, 1] at which the distance is at most r; 0 if it is so at the start.
  std::optional<Real> first_time(const Real& r) const;

 private:
  /// Distance less r at a time, and how fast it changes there.
  struct Sample {
    Real time, gap, slope;
    Real zero_of_tangent() const { return time - gap / slope; }
  };
  Sample sample(const Real& t, const Real& r) const {
    const Vec<Real> o = offset(t);
    const Real d = norm(o);
    return {t, d - r, d > 0 ? Real(-dot(o, travel_) / d) : Real(0)};
  }

  Triangle<Real> triangle_;
  Vec<Real> start_, travel_;
};

template <class Real>
std::optional<Real> Approach<Real>::first_time(const Real& r) const {
  constexpr int enough = 200;
  if (r < 0) return std::nullopt;
  Sample from = sample(Real(0), r), to = sample(Real(1), r);
  if (from.gap <= 0) return Real(0);
  for (int i = 0; i < enough; ++i) {
    if (!(from.slope < 0)) return std::nullopt;  // rising: never again
    if (to.gap > 0) {  // both apart: between the zeros of their tangents, or nowhere
      if (!(to.slope > 0)) return std::nullopt;  // still falling at the end
      const Real low = std::max(from.zero_of_tangent(), from.time),
                 high = std::min(to.zero_of_tangent(), to.time);
      const Real middle = (low + high) / 2;
      if (low > high || !(from.time < middle && middle < to.time)) return std::nullopt;
      const Sample s = sample(middle, r);
      (s.gap > 0 && s.slope < 0 ? from : to) = s;
      continue;
    }
    const Real least = from.zero_of_tangent();
    const Real most = from.time - from.gap * (to.time - from.time) / (to.gap - from.gap);  // the chord's zero
    const Real width = to.time - from.time;
    for (const Real& t : {least, most, Real((from.time + to.time) / 2)}) {
      if (!(from.time < t && t < to.time)) continue;
      if (to.time - from.time < width / 4) break;
      const Sample s = sample(t, r);
      (s.gap > 0 ? from : to) = s;
    }
    if (!(to.time - from.time < width)) break;  // nothing in between
  }
  return to.gap <= 0 ? std::optional<Real>(to.time) : std::nullopt;
}

}  // namespace truth
