#include "first_contact/sweep/moved_out.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/mesh_edges.hpp"
#include "first_contact/sweep/first_root.hpp"

namespace first_contact {

namespace {

/// A path that halves its distance from the truth in every step has reached it, in double, after this many.
constexpr int enough_steps = 64;

/// A path at a smaller angle to a plane, in radians, crosses it at no certain time.
constexpr double flat = 0x1p-30;

/// The normal of a long, thin triangle is turned by rounding; for a sphere that comes in at a flat angle the
/// time is then wrong although the hit is not. The distance itself knows no normal, and falls along the path
/// ever more slowly: Newton's steps lead to r from any time, and never beyond it from an earlier one.
///
/// None is needed if the normal is steady, wrong by 5 eps: then the height and its change along the path are
/// wrong by 7 eps (|m| + |V|), and r |n| by 2 eps r, which is less than half of the tolerance. A point may
/// still come in beside the triangle, within its plane.
std::optional<double> settled(double t, const Moving<Sphere>& moving, const Facet& facet, double tolerance) {
  const auto& [center, radius] = moving.shape;
  if (facet.steady && radius > 0) return t;
  const Triangle& triangle = facet.triangle;
  const Vector a = triangle.a - center, b = triangle.b - center, c = triangle.c - center;
  for (int i = 0; i < enough_steps; ++i) {
    const Vector path = t * moving.displacement;
    const Vector offset = path - closest_point(path, a, b, c);
    const double gap = offset.norm() - radius;
    if (std::abs(gap) <= tolerance) return t;
    t -= gap * offset.norm() / offset.dot(moving.displacement);
    if (!(t >= 0 && t <= 1)) return std::nullopt;
  }
  return std::nullopt;
}

/// How far the centre is, at the start, from a face that it is straight above: by the distance itself, again,
/// if the normal is not steady.
double height_over(const Facet& facet, const Point& center, double height) {
  if (facet.steady) return std::abs(height) / facet.length;
  return (center - closest_point(center, facet.triangle)).norm();
}

}  // namespace

//! [touch_face]
std::optional<Touch> touch_face(const Moving<Sphere>& moving, const Facet& facet, bool surely_within) {
  const auto& [center, radius] = moving.shape;
  if (facet.thin_for(radius)) return std::nullopt;  // its edges answer for it
  const Vector m = center - facet.corner;
  const double height = facet.normal.dot(m);  // |n| times the distance from the plane
  const double toward = facet.normal.dot(moving.displacement);
  const double side = height != 0 ? std::copysign(1.0, height) : -std::copysign(1.0, toward);
  const double gap = std::abs(height) - radius * facet.length;  // |n| E'.S0
  const double approach = side * toward;                        // |n| N.V
  if (!(approach < 0) || !(gap <= -approach)) return std::nullopt;

  // Move the sphere's lowest point instead of the face. If they overlap, look straight down on the face.
  const Vector normal = side * facet.unit_normal();
  const Vector low = gap > 0 ? Vector(radius * normal) : Vector(Vector::Zero());
  const Vector along = gap > 0 ? moving.displacement : facet.normal;
  const auto& [a, b, c] = facet.triangle;
  if (!surely_within &&
      !weights_where_line_meets(along, a - center + low, b - center + low, c - center + low))
    return std::nullopt;

  const double tolerance =
      rounding_of_distance * (m.norm() + facet.longest + moving.displacement.norm() + radius);
  auto t = gap > 0 ? settled(-gap / approach, moving, facet, tolerance) : 0.0;
  // A point goes through: its distance is least where it is 0, and at a thin triangle Newton's steps may leap
  // to and fro. There the plane's own time will do, but not that of a path within the plane.
  if (!t && radius == 0 && -approach > flat * facet.length * moving.displacement.norm()) t = -gap / approach;
  if (!t) return std::nullopt;
  const double distance = std::min(radius, height_over(facet, center, height));
  return Touch{
      *t, distance, normal, center + *t * moving.displacement - distance * normal, Feature::face, tolerance};
}
//! [touch_face]

//! [touch_edge]
std::optional<Touch> touch_edge(const Moving<Sphere>& moving, const Point& a, const Point& b) {
  const auto& [center, radius] = moving.shape;
  const Vector e = b - a, m = center - a;
  const double length = e.norm();
  const double tolerance = rounding_of_distance * (m.norm() + length + moving.displacement.norm() + radius);

  // e x turns the plane across the edge by a right angle, stretched by |e|: the cylinder becomes a ball.
  const auto entry =
      first_root(e.cross(m), e.cross(moving.displacement), length * radius, length * tolerance);
  if (!entry) return std::nullopt;
  const Vector arrival = m + entry->time * moving.displacement;
  const double along = arrival.dot(e);
  const bool before_a = along < 0;
  const bool behind_b = (arrival - e).dot(e) > 0;
  if (before_a || behind_b) return std::nullopt;  // not on this edge: its ends answer

  const Vector normal = entry->direction.cross(e).normalized();
  const double distance = entry->time > 0 ? radius : std::min(radius, e.cross(m).norm() / length);
  return Touch{entry->time, distance, normal, a + along / (length * length) * e, Feature::edge, tolerance};
}
//! [touch_edge]

//! [touch_vertex]
std::optional<Touch> touch_vertex(const Moving<Sphere>& moving, const Point& vertex) {
  const auto& [center, radius] = moving.shape;
  const Vector m = center - vertex;
  const double tolerance = rounding_of_distance * (m.norm() + moving.displacement.norm() + radius);
  const auto entry = first_root(m, moving.displacement, radius, tolerance);
  if (!entry) return std::nullopt;
  const double distance = entry->time > 0 ? radius : std::min(radius, m.norm());
  return Touch{entry->time, distance, entry->direction, vertex, Feature::vertex, tolerance};
}
//! [touch_vertex]

bool earlier(const Touch& a, const Touch& b) {
  const auto key = [](const Touch& touch) {
    return std::make_tuple(touch.time, touch.feature, touch.distance);
  };
  if (key(a) != key(b)) return key(a) < key(b);
  if (a.point != b.point) return comes_before(a.point, b.point);
  return comes_before(a.normal, b.normal);
}

}  // namespace first_contact
