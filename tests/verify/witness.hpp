#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/moving.hpp"
#include "verify/truth.hpp"

/// \file
/// What is known of each triangle that a sphere comes near, and which of several is the nearest around a point.

namespace judge {

using namespace first_contact;

/// What rounding may take from or add to the radius, for one triangle.
/// \see bvh.hpp
inline double bound(const Triangle& t, const Moving<Sphere>& moving) {
  const auto& [s, r] = moving.shape;
  const double corner = std::max({(t.a - s).norm(), (t.b - s).norm(), (t.c - s).norm()});
  const double side = std::max({(t.b - t.a).norm(), (t.c - t.b).norm(), (t.a - t.c).norm()});
  return 16 * std::numeric_limits<double>::epsilon() * (corner + side + moving.displacement.norm() + r);
}

/// A triangle that the sphere comes near, and all that the judgement asks of it.
template <class Real>
struct Witness {
  Triangle triangle;
  truth::Approach<Real> approach;
  Real bound;
  bool overlaps;  // at the start, or nearly so
};

template <class Real>
std::vector<Witness<Real>> witnesses(const Mesh& mesh, const Moving<Sphere>& moving) {
  std::vector<Witness<Real>> result;
  const auto& [s, r] = moving.shape;
  const Vector& v = moving.displacement;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const double size = std::max((t.b - t.a).norm(), (t.c - t.a).norm());
    const double k = v.isZero(0) ? 0 : std::clamp((t.a - s).dot(v) / v.squaredNorm(), 0.0, 1.0);
    if ((s + k * v - t.a).norm() > 1.000001 * (r + size)) continue;  // out of reach by far
    const Real delta = bound(t, moving);
    truth::Approach<Real> approach(t, s, v);
    const bool overlaps = approach.distance(Real(0)) <= Real(r) + delta;
    result.push_back({t, approach, delta, overlaps});
  }
  return result;
}

inline bool has(const Triangle& t, const Point& p) { return t.a == p || t.b == p || t.c == p; }

/// A triangle is around a vertex that it has, and around an edge of which it has both ends.
template <class Real>
bool is_around(const truth::Vec<Real>& point, const Triangle& with_it, const Triangle& other,
               const Real& near) {
  const std::array<Point, 3> corner{with_it.a, with_it.b, with_it.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &p = corner[i], &q = corner[(i + 1) % 3];
    if (!has(other, p)) continue;
    if (norm(point - truth::exact<Real>(p)) <= near) return true;
    if (has(other, q) && norm(truth::Triangle<Real>(Triangle(p, q, q)).from(point)) <= near) return true;
  }
  return false;
}

enum class Answer { no, perhaps, yes };

/// May rounding take the nearest point of a triangle off its border, to where the other one is not? It may if
/// a little way inside the distance is all but the same.
template <class Real>
bool may_leave(const Witness<Real>& one, const Triangle& other, const Real& t, const Real& step) {
  const truth::Vec<Real> point = one.approach.point(t), to_center = Real(-1) * one.approach.offset(t);
  const Triangle& own = one.triangle;
  for (const Point& target : {own.a, own.b, own.c, Point((own.a + own.b + own.c) / 3)}) {
    const truth::Vec<Real> way = truth::exact<Real>(target) - point;
    const Real length = norm(way);
    if (!(length > step)) continue;
    const truth::Vec<Real> inside = (step / length) * way;
    const Real farther = norm(to_center - inside) - norm(to_center);
    if (farther <= one.bound && norm(truth::Triangle<Real>(other).from(point + inside)) > one.bound)
      return true;
  }
  return false;
}

/// Is the nearest point of a triangle nearer to the centre than the surface around it? A neighbour that holds
/// the point leads nearer if and only if it is nearer itself, since it is convex.
template <class Real>
Answer nearest_around(const Witness<Real>& one, const std::vector<Witness<Real>>& all, const Real& t) {
  const Real near = 4 * one.bound, hardly_near = 4000 * one.bound, tiny = one.bound / 1000;
  const Real distance = one.approach.distance(t);
  const truth::Vec<Real> point = one.approach.point(t);
  Answer answer = distance > 1000 * one.bound ? Answer::yes : Answer::perhaps;
  for (const Witness<Real>& other : all) {
    const Real nearer = distance - other.approach.distance(t);
    if (&other == &one || !(nearer > tiny) || !is_around(point, one.triangle, other.triangle, hardly_near))
      continue;
    answer = Answer::perhaps;
    if (nearer > near && is_around(point, one.triangle, other.triangle, near) &&
        !may_leave(one, other.triangle, t, Real(4 * near)))
      return Answer::no;
  }
  return answer;
}

/// Does the sphere go deeper into what it overlaps? In doubt within the angle in which a step along the
/// tangent is not noticed.
template <class Real>
Answer going_deeper(const Witness<Real>& one, const Moving<Sphere>& moving) {
  using std::sqrt;
  const truth::Vec<Real> down = one.approach.offset(Real(0));
  const Real distance = norm(down), travel = moving.displacement.norm();
  if (!(distance > 1000 * one.bound)) return Answer::perhaps;
  const Real cosine = dot(down, truth::exact<Real>(moving.displacement)) / (distance * travel);
  const Real doubt = 4 * sqrt(one.bound / distance);
  return cosine > doubt ? Answer::yes : cosine > -doubt ? Answer::perhaps : Answer::no;
}

}  // namespace judge
