#include "first_contact/geometry/closest_point.hpp"

#include <algorithm>

#include "first_contact/geometry/facet.hpp"
#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

Point closest_point(const Point& point, const Point& a, const Point& b) {
  Vector e = b - a;
  if (!is_ordinary_square(squared_norm(e))) e *= unit_scale(largest(e));  // its length does not matter
  const double along = dot(point - a, e);
  if (!(along > 0)) return a;
  if (dot(point - b, e) >= 0) return b;
  return a + along / squared_norm(e) * e;
}

Point closest_point(const Point& point, const Point& a, const Point& b, const Point& c) {
  const double size = largest(a - point, b - point, c - point);
  if (const double unit = unit_scale(size, largest(point)); !is_ordinary(size) && is_ordinary(unit * size))
    return closest_point(unit * point, unit * a, unit * b, unit * c) / unit;
  Point best = closest_point(point, a, b);
  const auto offer = [&](const Point& candidate) {
    if (squared_norm(candidate - point) < squared_norm(best - point)) best = candidate;
  };
  offer(closest_point(point, b, c));
  offer(closest_point(point, c, a));
  const Facet facet({a, b, c});
  if (!weights_where_line_meets(facet.normal, a - point, b - point, c - point)) return best;
  // From the point down: to add up sides would cost the rounding of the longest, and a needle is much lower than that.
  const Vector normal = facet.unit_normal();
  const Point foot = point - dot(normal, point - facet.corner) * normal;
  if (!facet.is_beyond_needle(foot, rounding_of_distance * size)) offer(foot);
  return best;
}

}  // namespace first_contact
