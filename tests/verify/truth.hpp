#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// When does a moving sphere touch a mesh? By bisection in long double, without any formula of the library.
///
/// The distance of a triangle from a point that moves along a straight line first falls and then rises. So
/// its least value is where it turns, and the time at which it falls to r lies before that: both are found by
/// halving. Numbers of 64 bits are wrong by 1e-19 of a length, four thousand times less than the bounds that
/// are verified with them; tests/oracle holds the same method to 50 digits.

namespace truth {

using namespace first_contact;
using Real = long double;
using Vec = Eigen::Matrix<Real, 3, 1>;

/// The vector from a point to the nearest point of a triangle.
class ToTriangle {
 public:
  explicit ToTriangle(const Triangle& t) : a_(t.a.cast<Real>()), b_(t.b.cast<Real>()), c_(t.c.cast<Real>()) {}

  Vec from(const Vec& p) const {
    Vec best = to_side(p, a_, b_);
    const auto offer = [&](const Vec& other) {
      if (other.squaredNorm() < best.squaredNorm()) best = other;
    };
    offer(to_side(p, b_, c_));
    offer(to_side(p, c_, a_));
    // Inside: p - a = u (b - a) + v (c - a) + w (b - a) x (c - a), by Cramer's rule.
    const Vec f = b_ - a_, g = c_ - a_, n = f.cross(g), h = p - a_;
    const Real nn = n.squaredNorm();
    if (nn > 0) {
      const Real u = h.cross(g).dot(n) / nn, v = f.cross(h).dot(n) / nn;
      if (u >= 0 && v >= 0 && u + v <= 1) offer(-(h.dot(n) / nn) * n);
    }
    return best;
  }

 private:
  static Vec to_side(const Vec& p, const Vec& a, const Vec& b) {
    const Vec e = b - a, m = p - a;
    const Real along = m.dot(e), ee = e.squaredNorm();
    return -m + (along <= 0 ? Real(0) : along >= ee ? Real(1) : along / ee) * e;
  }

  Vec a_, b_, c_;
};

/// The way of a sphere's centre past one triangle.
class Approach {
 public:
  Approach(const Triangle& triangle, const Moving<Sphere>& moving)
      : triangle_(triangle),
        start_(moving.shape.center.cast<Real>()),
        travel_(moving.displacement.cast<Real>()) {
    const auto falling = [&](Real t) { return to_triangle(t).dot(travel_) > 0; };
    turn_ = !falling(0) ? 0 : falling(1) ? 1 : last(falling, 0, 1);
  }

  Real distance(Real t) const { return to_triangle(t).norm(); }
  /// The first time at which the distance is at most r; 0 if it is at the start.
  std::optional<Real> first_time(Real r) const {
    if (r < 0 || distance(turn_) > r) return std::nullopt;
    if (distance(0) <= r) return Real(0);
    return last([&](Real t) { return distance(t) > r; }, 0, turn_);
  }

 private:
  Vec to_triangle(Real t) const { return triangle_.from(start_ + t * travel_); }
  /// Until when is a condition true that is true at `from` and not at `to`?
  template <class Condition>
  static Real last(const Condition& condition, Real from, Real to) {
    while (true) {
      const Real middle = (from + to) / 2;
      if (!(from < middle && middle < to)) return to;
      (condition(middle) ? from : to) = middle;
    }
  }

  ToTriangle triangle_;
  Vec start_, travel_;
  Real turn_;
};

/// The first times for a radius that is larger, and smaller, by a bound: the sweep's answer must lie between.
struct Between {
  std::optional<Real> earliest, latest;
};

inline Between first_times(const Mesh& mesh, const Moving<Sphere>& moving, Real bound) {
  Between result;
  const auto keep = [](std::optional<Real>& first, const std::optional<Real>& other) {
    if (other && (!first || *other < *first)) first = other;
  };
  const Real r = moving.shape.radius;
  const Point middle = moving.shape.center + moving.displacement / 2;
  const double reach = moving.displacement.norm() / 2 + moving.shape.radius;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const double size = std::max((t.b - t.a).norm(), (t.c - t.a).norm());
    if ((t.a - middle).norm() > (reach + size) * 1.000001) continue;  // out of reach by far
    const Approach approach(t, moving);
    keep(result.earliest, approach.first_time(r + bound));
    keep(result.latest, approach.first_time(r - bound));
  }
  return result;
}

}  // namespace truth
