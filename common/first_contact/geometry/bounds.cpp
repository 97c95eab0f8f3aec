#include "first_contact/geometry/bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

// What the rounded sum of a and b lacks to the exact one (Knuth, The Art of Computer Programming 2, 4.2.2).
double missing(double a, double b, double sum) {
  const double of_b = sum - a;
  return (a - (sum - of_b)) + (b - of_b);
}

double sum_below(double a, double b) {
  const double sum = a + b;
  return missing(a, b, sum) < 0 ? std::nextafter(sum, -std::numeric_limits<double>::infinity()) : sum;
}

Vector sum_below(const Vector& a, const Vector& b) {
  return a.binaryExpr(b, [](double x, double y) { return sum_below(x, y); });
}
Vector sum_above(const Vector& a, const Vector& b) { return -sum_below(-a, -b); }

// Do all corners lie beyond the box in this direction? The box is that of the vectors from -half to half.
bool parts(const Vector& direction, const std::array<Vector, 3>& corners, const Vector& half) {
  const double reach = dot(half, direction.cwiseAbs());
  const double a = dot(direction, corners[0]), b = dot(direction, corners[1]), c = dot(direction, corners[2]);
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

}  // namespace

Bounds bounds_between(const Point& low, const Point& high) {
  require_finite(low, "bounds' low corner");
  require_finite(high, "bounds' high corner");
  if (!(low.array() <= high.array()).all())
    refuse("bounds from (" + to_text(low) + ") to (" + to_text(high) + ")", "low must not be above high");
  return {low, high};
}

Point middle_of(const Bounds& box) { return 0.5 * box.min() + 0.5 * box.max(); }

double largest_coordinate(const Bounds& box) {
  return box.isEmpty() ? 0 : std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

Bounds grown(const Bounds& box, double distance) {
  const Vector outward = Vector::Constant(distance);
  return {box.min() - outward, box.max() + outward};
}

Bounds bounds_of(std::span<const Point> points) {
  Bounds bounds;
  for (const Point& point : points) bounds.extend(point);
  return bounds;
}

Bounds bounds_of(const Triangle& triangle) {
  return bounds_of(std::array{triangle.a, triangle.b, triangle.c});
}

Bounds bounds_of(const Sphere& sphere) { return bounds_of(sphere, Vector::Zero()); }

Bounds bounds_of(const Sphere& sphere, const Vector& displacement) {
  const Vector radius = Vector::Constant(sphere.radius);
  Bounds bounds;
  bounds.min() = sum_below(sum_below(sphere.center, displacement.cwiseMin(0)), -radius);
  bounds.max() = sum_above(sum_above(sphere.center, displacement.cwiseMax(0)), radius);
  return bounds;
}

Bounds bounds_of(std::span<const Bounds> all) {
  Bounds bounds;
  for (const Bounds& one : all) bounds.extend(one);
  return bounds;
}

//! [overlap_bounds]
bool overlap(const Bounds& a, const Bounds& b) {
  return (a.min().array() <= b.max().array()).all() && (b.min().array() <= a.max().array()).all();
}
//! [overlap_bounds]

bool overlap(const Triangle& triangle, const Bounds& box) {
  if (!overlap(bounds_of(triangle), box)) return false;  // the box's own three directions
  const Point middle = middle_of(box);
  Vector half = 0.5 * box.max() - 0.5 * box.min();
  std::array<Vector, 3> corners{triangle.a - middle, triangle.b - middle, triangle.c - middle};
  std::array<Vector, 3> edges{triangle.b - triangle.a, triangle.c - triangle.b, triangle.a - triangle.c};
  if (const double size = std::max(largest(half), largest(corners[0], corners[1], corners[2]));
      !is_ordinary(size)) {
    half *= unit_scale(size);
    for (std::size_t i = 0; i < 3; ++i) corners[i] *= unit_scale(size), edges[i] *= unit_scale(size);
  }
  if (parts(edges[0].cross(edges[1]), corners, half)) return false;
  for (const Vector& edge : edges)
    for (int axis = 0; axis < 3; ++axis)
      if (parts(edge.cross(Vector::Unit(axis)), corners, half)) return false;
  return true;
}

//! [passage]
std::optional<Passage> passage(const Point& start, const Vector& displacement, const Bounds& box,
                               const Passage& part) {
  if (box.isEmpty()) return std::nullopt;
  auto [enter, leave] = part;
  for (int axis = 0; axis < 3; ++axis) {
    const double s = start[axis], v = displacement[axis];
    if (v == 0 && (s < box.min()[axis] || s > box.max()[axis])) return std::nullopt;
    if (v == 0) continue;  // within this slab at all times
    const double to_low = (box.min()[axis] - s) / v, to_high = (box.max()[axis] - s) / v;
    enter = std::max(enter, std::min(to_low, to_high));
    leave = std::min(leave, std::max(to_low, to_high));
  }
  if (enter > leave) return std::nullopt;
  return Passage{enter, leave};
}
//! [passage]

}  // namespace first_contact
