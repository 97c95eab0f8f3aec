#include "first_contact/geometry/facet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "first_contact/geometry/accurate_cross.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

/// The rounding of a cross product turns the normal by up to eps l / h, also along the triangle: over its
/// length l the plane then leaves the triangle by eps l^2 / h. Where that is more than 16 eps l, it is
/// worked out with more care.
/// \see tests/oracle/verify.cpp
constexpr double thin = 1 / 16.0;

}  // namespace

CornerNormal::CornerNormal(const Point& a, const Point& b, const Point& c) {
  Vector ab = b - a, bc = c - b, ca = a - c;
  const double size = largest(ab, bc, ca);
  if (!is_ordinary(size)) {
    unit = unit_scale(size);
    ab *= unit, bc *= unit, ca *= unit;
  }
  const double ab2 = squared_norm(ab), bc2 = squared_norm(bc), ca2 = squared_norm(ca);
  const double longest2 = std::max({ab2, bc2, ca2});
  longest = std::sqrt(longest2);
  const bool at_a = bc2 >= std::max(ab2, ca2);
  const bool at_b = !at_a && ca2 >= ab2;
  corner = at_a ? a : at_b ? b : c;
  const Vector &in = at_a ? ca : at_b ? ab : bc, &out = at_a ? ab : at_b ? bc : ca;
  normal = in.cross(out);
  if (squared_norm(normal) < thin * longest2 * (thin * longest2)) normal = accurate_cross<double>(in, out);
}

Facet::Facet(const Triangle& t) : CornerNormal(t.a, t.b, t.c), triangle(t), length(norm(normal)) {}

bool Facet::thin_for(double radius) const {
  // Let l be the longest side and h = |n| / l the height above it. A ball of radius r that lies on the edges
  // on both sides of the triangle sags through its face by at most h^2 / 2r. The rounded normal, in turn, may
  // be tilted by eps l / h, which costs r (eps l / h)^2 / 2. Where h^2 = 2 eps l r, the first is eps l and
  // the second eps l / 4: with the edges for thinner triangles and the face for thicker ones, no triangle
  // errs by more than eps l.
  constexpr double eps = std::numeric_limits<double>::epsilon();
  return !(2 * eps * (unit * radius) * (longest * longest * longest) < length * length);
}

bool Facet::is_beyond_needle(const Point& place, double tolerance) const {
  if (length > 2 * tolerance * unit * longest) return false;
  const auto& [a, b, c] = triangle;
  const Point &from = corner == a ? b : a, &to = corner == c ? b : c;
  const Vector side = to - from;
  return dot(place - from, side) < 0 || dot(place - to, side) > 0;
}

}  // namespace first_contact
