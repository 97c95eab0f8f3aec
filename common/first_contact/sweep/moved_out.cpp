#include "first_contact/sweep/moved_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/geometry/mesh_edges.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/sweep/first_root.hpp"

namespace first_contact {

namespace {

/// What part of the tolerance of 16 eps L may rounding take from, or add to, the height over a face? The
/// normal turns by less than 3.4 eps, its product with the way to a corner is wrong by 2 eps, and all that of
/// a triangle whose sides were rounded, which is less than 1 eps away: 7 eps L at most.
constexpr double rounding_of_height = 7.0 / 16;

/// From the distance to the line of a side, within the plane: a difference and two products, 4 eps L at most.
/// Height and side, each wrong once where it is asked and once where it is true, are at right angles to each
/// other; together they are within the tolerance.
constexpr double rounding_of_side = 4.0 / 16;

/// From the distance to an edge or a vertex: 8 eps L at most. A path that passes them by so much beyond r is
/// taken for one that grazes: so none that does is missed, and none is invented beyond the tolerance.
constexpr double rounding_of_graze = 8.0 / 16;

/// Below this sine of its angle to a triangle's plane the path of a point counts as one within the plane,
/// which is the affair of the edges. Since rounding turns the normal so little, the true sine is then below
/// 20 eps, and the path cannot lead from 16 eps L before the plane to 16 eps L behind it: no point gets
/// through.
/// \see tests/oracle/verify.cpp
constexpr double within_plane = rounding_of_distance;

/// The largest of the lengths that a touch of a feature consists of; m is the way to the centre from the
/// feature's corner.
double size_of(const Moving<Sphere>& moving, const Vector& m, double feature) {
  return std::max({largest(m), feature, largest(moving.displacement), moving.shape.radius});
}

/// The same question in a unit in which the size is ordinary. If there is none, nothing moves, or by less than
/// 2^-900 of the centre's own coordinates.
template <class Ask>
std::optional<Touch> in_unit(const Moving<Sphere>& moving, double size, const Ask& ask) {
  const double unit = unit_scale(size, largest(moving.shape.center));
  if (!is_ordinary(unit * size)) return std::nullopt;
  const auto& [sphere, displacement] = moving;
  auto touch = ask({{unit * sphere.center, unit * sphere.radius}, unit * displacement}, unit);
  if (!touch) return std::nullopt;
  touch->distance /= unit;
  touch->point /= unit;
  touch->tolerance /= unit;
  return touch;
}

/// Does the path of a point, or a line through it, meet the face? The point is `low` below the centre.
bool meets(const Facet& facet, const Point& center, const Vector& low, const Vector& direction) {
  const auto& [a, b, c] = facet.triangle;
  return weights_where_line_meets(direction, a - center + low, b - center + low, c - center + low)
      .has_value();
}

/// Is the path so flat that the place where it meets the plane is not certain enough? The height over the
/// plane moves that place by x = height / sine. A sphere is then farther from the face's border than from its
/// plane by up to x^2 / 2r, a point by x: both are well within the tolerance unless the path is flat.
bool is_flat(double approach, double straight, double radius, double tolerance) {
  return approach * approach * (radius + 2 * tolerance) < straight * straight * tolerance;
}

//! [landing]
/// When does the lowest point, `low` below the centre, arrive on the face by a flat path? When it meets the
/// plane is as uncertain as the height, and it may be far beyond the border then. So the time is cut to that
/// between the sides (Cyrus and Beck), and between the ends of the longest, since two sides may meet there at
/// any angle; all are moved out by their rounding. Then the height decides.
std::optional<double> landing(const Moving<Sphere>& moving, const Vector& low, const Facet& facet, double gap,
                              double approach, double tolerance) {
  const std::array<Point, 3> corners{facet.triangle.a, facet.triangle.b, facet.triangle.c};
  double enter = 0, leave = 1;
  const auto cut = [&](const Point& border, const Vector& inward) {
    const Vector from = moving.shape.center - border - low;
    const double inside = dot(inward, from) + rounding_of_side * tolerance * norm(inward);
    const double rate = dot(inward, moving.displacement);
    if (rate > 0) enter = std::max(enter, -inside / rate);
    if (rate < 0) leave = std::min(leave, inside / -rate);
    if (rate == 0 && inside < 0) leave = -1;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &from = corners[i], &to = corners[(i + 1) % 3];
    cut(from, facet.normal.cross(to - from));
    if (corners[(i + 2) % 3] != facet.corner) continue;  // not the longest
    cut(from, to - from);
    cut(to, from - to);
  }
  if (!(enter <= leave)) return std::nullopt;
  const double t = std::clamp(-gap / approach, enter, leave);
  const double height = gap + t * approach;
  if (std::abs(height) > rounding_of_height * tolerance * facet.length) return std::nullopt;
  return t;
}
//! [landing]

}  // namespace

//! [touch_face]
std::optional<Touch> touch_face(const Moving<Sphere>& moving, const Facet& facet, bool surely_within) {
  const auto& [center, radius] = moving.shape;
  if (facet.thin_for(radius)) return std::nullopt;  // its edges answer for it
  const Vector m = center - facet.corner;
  const double size = size_of(moving, m, facet.longest / facet.unit);
  if (!is_ordinary(size))
    return in_unit(moving, size, [&](const Moving<Sphere>& scaled, double unit) {
      const auto& [a, b, c] = facet.triangle;
      return touch_face(scaled, Facet({unit * a, unit * b, unit * c}), surely_within);
    });
  const double height = dot(facet.normal, m);  // |n| times the distance from the plane
  const double toward = dot(facet.normal, moving.displacement);
  const double side = height != 0 ? std::copysign(1.0, height) : -std::copysign(1.0, toward);
  const double gap = std::abs(height) - radius * facet.length;  // |n| E'.S0
  const double approach = side * toward;                        // |n| N.V
  if (!(approach < 0) || !(gap <= -approach)) return std::nullopt;

  const double tolerance =
      rounding_of_distance * (norm(m) + facet.longest / facet.unit + norm(moving.displacement) + radius);
  const double straight = facet.length * norm(moving.displacement);  // -approach at a right angle
  const bool apart = gap > 0, flat = apart && is_flat(approach, straight, radius, tolerance);
  if (flat && radius == 0 && -approach <= within_plane * straight) return std::nullopt;

  // Move the sphere's lowest point instead of the face. If they overlap, look straight down on the face.
  const Vector normal = side * facet.unit_normal();
  const Vector low = apart ? Vector(radius * normal) : Vector(Vector::Zero());
  const Vector along = apart ? moving.displacement : facet.normal;
  if (!flat && !surely_within && !meets(facet, center, low, along)) return std::nullopt;
  std::optional<double> t = apart ? -gap / approach : 0;
  if (flat) t = landing(moving, low, facet, gap, approach, tolerance);
  if (!t) return std::nullopt;
  if (!flat && !surely_within && facet.is_beyond_needle(center - low + *t * moving.displacement, tolerance))
    return std::nullopt;

  const double distance = std::min(radius, std::abs(height) / facet.length);
  return Touch{
      *t, distance, normal, center + *t * moving.displacement - distance * normal, Feature::face, tolerance};
}
//! [touch_face]

//! [touch_edge]
std::optional<Touch> touch_edge(const Moving<Sphere>& moving, const Point& a, const Point& b) {
  const auto& [center, radius] = moving.shape;
  const Vector side = b - a, m = center - a;
  const double size = norm(m) + norm(side) + norm(moving.displacement) + radius;
  if (!is_ordinary(size))
    return in_unit(moving, size, [&](const Moving<Sphere>& scaled, double unit) {
      return touch_edge(scaled, unit * a, unit * b);
    });
  const double tolerance = rounding_of_distance * size;

  const Vector e =
      is_ordinary(norm(side)) ? side : Vector(unit_scale(largest(side)) * side);  // any length will do
  const double length = norm(e);

  // e x turns the plane across the edge by a right angle, stretched by |e|: the cylinder becomes a ball.
  const auto entry = first_root(e.cross(m), e.cross(moving.displacement), length * radius,
                                length * rounding_of_graze * tolerance);
  if (!entry) return std::nullopt;
  const Vector arrival = m + entry->time * moving.displacement;
  const double along = dot(arrival, e);
  const bool before_a = along < 0;
  const bool behind_b = dot(arrival - side, e) > 0;
  if (before_a || behind_b) return std::nullopt;  // not on this edge: its ends answer

  const Vector normal = normalized(entry->direction.cross(e));
  const double distance = entry->time > 0 ? radius : std::min(radius, norm(e.cross(m)) / length);
  return Touch{entry->time, distance, normal, a + along / (length * length) * e, Feature::edge, tolerance};
}
//! [touch_edge]

//! [touch_vertex]
std::optional<Touch> touch_vertex(const Moving<Sphere>& moving, const Point& vertex) {
  const auto& [center, radius] = moving.shape;
  const Vector m = center - vertex;
  const double size = norm(m) + norm(moving.displacement) + radius;
  if (!is_ordinary(size))
    return in_unit(moving, size, [&](const Moving<Sphere>& scaled, double unit) {
      return touch_vertex(scaled, unit * vertex);
    });
  const double tolerance = rounding_of_distance * size;
  const auto entry = first_root(m, moving.displacement, radius, rounding_of_graze * tolerance);
  if (!entry) return std::nullopt;
  const double distance = entry->time > 0 ? radius : std::min(radius, norm(m));
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
