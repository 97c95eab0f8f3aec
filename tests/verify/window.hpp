#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "verify/witness.hpp"

/// \file
/// When may a first contact be at the earliest, and when must it be at the latest?

namespace judge {

/// When a contact may be at the earliest and must be at the latest; never, if none may or must be.
template <class Real>
struct Window {
  std::optional<Real> earliest, latest;
};

template <class Real>
void keep(std::optional<Real>& first, const std::optional<Real>& other) {
  if (other && (!first || *other < *first)) first = other;
}

/// The path of a point, and on which side of things it passes.
template <class Real>
class Path {
 public:
  explicit Path(const Moving<Sphere>& moving)
      : start_(truth::exact<Real>(moving.shape.center)), travel_(truth::exact<Real>(moving.displacement)) {}

  /// How far to the left of p to q it passes, seen along the path; 0 where the two are parallel.
  Real left_of(const Point& p, const Point& q) const {
    const truth::Vec<Real> a = truth::exact<Real>(p), across = cross(truth::exact<Real>(q) - a, travel_);
    const Real length = norm(across);
    return length > 0 ? Real(dot(start_ - a, across) / length) : Real(0);
  }
  /// When it is behind the plane of three points by more than `depth`, having been before it by as much.
  std::optional<Real> passes(const Point& p, const Point& q, const Point& s, const Real& depth) const {
    const truth::Vec<Real> a = truth::exact<Real>(p);
    const truth::Vec<Real> n = cross(truth::exact<Real>(q) - a, truth::exact<Real>(s) - a);
    const Real length = norm(n);
    if (!(length > 0)) return std::nullopt;
    const Real begin = dot(start_ - a, n) / length, end = begin + dot(travel_, n) / length;
    const Real before = begin < 0 ? Real(-begin) : begin, behind = begin < 0 ? end : Real(-end);
    if (!(before > depth && behind > depth)) return std::nullopt;
    return (before + depth) / (before + behind);
  }

 private:
  truth::Vec<Real> start_, travel_;
};

/// A point cannot be nearer to a face than its radius, which is 0; but where it goes through, it must hit:
/// if its path, seen from its start, has all sides of the face on the same hand, and none within the bound.
template <class Real>
std::optional<Real> goes_through(const Witness<Real>& one, const Path<Real>& path) {
  const auto& [a, b, c] = one.triangle;
  const Real ab = path.left_of(a, b), bc = path.left_of(b, c), ca = path.left_of(c, a);
  const Real least = std::min({ab, bc, ca}), most = std::max({ab, bc, ca});
  if (!(least > one.bound || -most > one.bound)) return std::nullopt;
  return path.passes(a, b, c, one.bound);
}

/// ... as it must where it goes through two faces with a side in common, on that side or beside it: through
/// their outline.
template <class Real>
std::optional<Real> goes_through_seam(const Witness<Real>& one, const Witness<Real>& other,
                                      const Path<Real>& path) {
  const Real bound = std::max(one.bound, other.bound);
  const std::array<Point, 3> corner{one.triangle.a, one.triangle.b, one.triangle.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = corner[i], &b = corner[(i + 1) % 3], &c = corner[(i + 2) % 3];
    const auto& [p, q, s] = other.triangle;
    if (!has(other.triangle, a) || !has(other.triangle, b)) continue;
    const Point& d = p != a && p != b ? p : q != a && q != b ? q : s;
    const std::array<Real, 4> sides{path.left_of(b, c), path.left_of(c, a), path.left_of(a, d),
                                    path.left_of(d, b)};
    const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
    if (!(*least > bound || -*most > bound)) continue;
    const auto first = path.passes(a, b, c, bound), second = path.passes(b, a, d, bound);
    if (first && second) return std::max(*first, *second);
  }
  return std::nullopt;
}

/// Of a sphere that is apart at the start, the first touch of any triangle counts.
template <class Real>
Window<Real> from_apart(const std::vector<Witness<Real>>& all, const Moving<Sphere>& moving) {
  Window<Real> window;
  const Real r = moving.shape.radius;
  for (const Witness<Real>& one : all) {
    keep(window.earliest, one.approach.first_time(r + one.bound));
    keep(window.latest, one.approach.first_time(r - one.bound));
  }
  if (moving.shape.radius > 0) return window;
  const Path<Real> path(moving);
  for (const Witness<Real>& one : all) {
    keep(window.latest, goes_through(one, path));
    for (const Witness<Real>& other : all)
      if (&other != &one) keep(window.latest, goes_through_seam(one, other, path));
  }
  return window;
}

/// Of one that overlaps, each touch counts of what is nearest to the centre in its surroundings; it must be
/// seen if it is so for any radius within the bound. What it gets free of may hide an edge from it until it
/// is over the face beyond: then it is in that face without having come to it.
template <class Real>
Window<Real> from_overlap(const std::vector<Witness<Real>>& all, const Moving<Sphere>& moving) {
  Window<Real> window;
  const Real r = moving.shape.radius;
  for (const Witness<Real>& one : all) {
    const Answer deeper = one.overlaps ? going_deeper(one, moving) : Answer::yes;
    if (deeper == Answer::no) continue;
    const auto first = one.approach.first_time(r + one.bound), last = one.approach.first_time(r - one.bound);
    const Answer nearest = first ? nearest_around(one, all, *first) : Answer::no;
    if (first && nearest != Answer::no) keep(window.earliest, first);
    if (last && deeper == Answer::yes && (nearest == Answer::yes || *first == 0) &&
        nearest_around(one, all, *last) == Answer::yes)
      keep(window.latest, last);
  }
  return window;
}

}  // namespace judge
