#include "first_contact/sweep/shared_middle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "first_contact/geometry/products.hpp"

namespace first_contact {

namespace {

using Polygon = std::vector<Point>;

/// Grows with the angle of (x, y), from -2 to 2: what atan2 tells, by a sum and a quotient alone, which every machine
/// rounds alike.
double angle_rank(double x, double y) {
  const double size = std::abs(x) + std::abs(y);
  const double part = size > 0 ? y / size : 0;
  return x >= 0 ? part : std::copysign(2, y) - part;
}

/// In order around their middle, anticlockwise as seen from the tip of the normal.
Polygon around(Polygon corners, const Vector& normal) {
  const Point middle = mean(corners);
  const Vector u = normal.unitOrthogonal(), v = normal.cross(u);
  const auto angle = [&](const Point& p) { return angle_rank(dot(u, p - middle), dot(v, p - middle)); };
  // Stable: corners of one angle stay in their order, whichever standard library sorts.
  std::stable_sort(corners.begin(), corners.end(),
                   [&](const Point& a, const Point& b) { return angle(a) < angle(b); });
  return corners;
}

/// What of a polygon lies on the inner side of a plane through `border` (Sutherland and Hodgman, 1974).
Polygon clipped(const Polygon& polygon, const Point& border, const Vector& inward, double rounding) {
  const auto depth = [&](const Point& p) { return dot(inward, p - border) + rounding; };
  Polygon rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double before = depth(from), after = depth(to);
    if (before >= 0) rest.push_back(from);
    if ((before < 0) != (after < 0)) rest.emplace_back(from + before / (before - after) * (to - from));
  }
  return rest;
}

/// What of the polygon lies over the other: over an edge, within its two ends and both of its sides.
Polygon over(Polygon polygon, const Polygon& other, const Vector& normal, double rounding) {
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Point &from = other[i], &to = other[(i + 1) % other.size()];
    const Vector along = normalized(to - from);
    polygon = clipped(polygon, from, normal.cross(along), rounding);
    if (other.size() == 2) polygon = clipped(polygon, from, along, rounding);
  }
  return polygon;
}

}  // namespace

std::vector<Point> farthest(std::span<const Point> vertices, const Vector& direction, double rounding) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Point& vertex : vertices) most = std::max(most, dot(direction, vertex));
  std::vector<Point> reaching;
  for (const Point& vertex : vertices) {
    if (most - dot(direction, vertex) > rounding) continue;
    if (std::find(reaching.begin(), reaching.end(), vertex) == reaching.end()) reaching.push_back(vertex);
  }
  return reaching;
}

Point shared_middle(std::span<const Point> first, const Vector& shift, std::span<const Point> second,
                    const Vector& normal, double rounding) {
  const Polygon lower = around(farthest(second, normal, rounding), normal);
  if (lower.size() == 1) return lower.front();
  Polygon upper = farthest(first, -normal, rounding);
  for (Point& p : upper) p += shift - dot(normal, p + shift - lower.front()) * normal;
  upper = around(upper, normal);
  const Polygon shared = over(upper, lower, normal, rounding);
  return mean(shared.empty() ? upper : shared);
}

}  // namespace first_contact
