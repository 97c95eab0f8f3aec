#include "first_contact/sweep/separating_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "first_contact/geometry/box_frame.hpp"
#include "first_contact/geometry/facet.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/sweep/shared_middle.hpp"

namespace first_contact {

namespace {

/// Two unit vectors whose cross product is shorter are parallel but for rounding: it would be no direction.
constexpr double parallel_axes = 16 * std::numeric_limits<double>::epsilon();

/// Where a hull lies along a direction.
struct Extent {
  double low, high;
};

Extent along(const Vector& axis, const Hull& hull, const Point& origin) {
  Extent extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Point& vertex : hull.vertices) {
    const double place = dot(axis, vertex - origin);
    extent.low = std::min(extent.low, place);
    extent.high = std::max(extent.high, place);
  }
  return extent;
}

/// How two hulls lie to each other along one direction, and how that changes.
struct Separation {
  double above;  // how far the mover's lower end is above the obstacle's upper end; negative: below it
  double below;  // how far the mover's upper end is below the obstacle's lower end
  double speed;  // of the mover, along the direction, in all of the motion

  double gap() const { return std::max(above, below); }
  double enter() const { return (speed > 0 ? below : -above) / speed; }
  double leave() const { return (speed > 0 ? -above : below) / speed; }
};

/// A direction, and how they lie along it.
struct Axis {
  Vector direction;
  Separation separation;

  /// From the obstacle to the mover: where they are apart, or the nearer way out; in the middle, against the
  /// motion.
  Vector outward() const {
    const auto& [above, below, speed] = separation;
    const bool up = above != below ? above > below : speed < 0;
    return up ? direction : Vector(-direction);
  }
  double approach() const { return dot(outward(), direction) * separation.speed; }
};

/// Two hulls, and all directions along which they may be apart.
class Encounter {
 public:
  Encounter(const Hull& moving, const Vector& displacement, const Hull& obstacle);
  bool overlapping() const;
  const Axis* way_in() const;
  const Axis* last_to_meet(double& time) const;
  double rounding() const { return rounding_; }

 private:
  /// They touch along a direction in which nothing moves; but for two that are flat and lie in one plane.
  bool slides_along(const Separation& separation) const {
    return separation.gap() >= -rounding_ && std::abs(separation.above - separation.below) > 2 * rounding_;
  }

  double rounding_ = 0;  // of a place along a direction
  std::vector<Axis> axes_;
};

Encounter::Encounter(const Hull& moving, const Vector& displacement, const Hull& obstacle) {
  const Point& origin = obstacle.vertices.front();
  double reach = norm(displacement);
  for (const Hull* hull : {&moving, &obstacle})
    for (const Point& vertex : hull->vertices) reach = std::max(reach, norm(vertex - origin));
  rounding_ = rounding_of_projection * reach;
  for (const Vector& axis : separating_axes(moving, obstacle)) {
    const Extent mover = along(axis, moving, origin), rest = along(axis, obstacle, origin);
    axes_.push_back({axis, {mover.low - rest.high, rest.low - mover.high, dot(axis, displacement)}});
  }
}

bool Encounter::overlapping() const {
  return std::all_of(axes_.begin(), axes_.end(), [](const Axis& axis) { return axis.separation.gap() <= 0; });
}

/// Of hulls that overlap: the direction of the shortest way out, if the motion leads against it; none if it
/// leads out, or slides along.
const Axis* Encounter::way_in() const {
  double shallowest = -std::numeric_limits<double>::infinity();
  for (const Axis& axis : axes_) shallowest = std::max(shallowest, axis.separation.gap());
  const Axis* steepest = nullptr;
  for (const Axis& axis : axes_) {
    if (axis.separation.gap() < shallowest) continue;
    const bool middle = axis.separation.above == axis.separation.below;
    if (middle && axis.separation.speed == 0) continue;
    if (!(axis.approach() < 0)) return nullptr;
    if (!steepest || axis.approach() < steepest->approach()) steepest = &axis;
  }
  return steepest;
}

/// Of hulls that are apart: the direction along which they meet last, if they still overlap along all others
/// then. What is common to the intervals is moved out by the rounding, so that nothing is missed for it.
const Axis* Encounter::last_to_meet(double& time) const {
  const Axis* last = nullptr;
  double leave = 1;
  time = 0;
  for (const Axis& axis : axes_) {
    const Separation& separation = axis.separation;
    if (separation.speed == 0) {
      if (separation.gap() > rounding_ || slides_along(separation)) return nullptr;
      continue;
    }
    const double slack = rounding_ / std::abs(separation.speed), enter = separation.enter();
    leave = std::min(leave, separation.leave() + slack);
    if (separation.gap() <= 0 || !(axis.approach() < 0)) continue;
    if (last && enter <= time + slack) continue;  // a face before an edge
    last = &axis;
    time = enter;
  }
  return time <= leave ? last : nullptr;
}

/// The number of vertices that reach farthest along a direction tells what they are.
Feature feature_of(const Hull& hull, const Vector& outward, double rounding) {
  const auto count = farthest(hull.vertices, outward, rounding).size();
  return count == 1 ? Feature::vertex : count == 2 ? Feature::edge : Feature::face;
}

}  // namespace

Hull::Hull(const Box& box) : flat(box.r.isZero(0) || box.s.isZero(0) || box.t.isZero(0)) {
  const auto corners = box.vertices();
  for (const unsigned i : {0U, 1U, 3U, 2U, 6U, 7U, 5U, 4U}) vertices.push_back(corners[i]);
  const BoxFrame frame(box);
  normals.assign(frame.normals.begin(), frame.normals.end());
  for (const Vector& axis : {box.r, box.s, box.t})
    if (!axis.isZero(0)) edges.push_back(normalized(axis));
}

Hull::Hull(const Triangle& triangle) : vertices{triangle.a, triangle.b, triangle.c}, flat(true) {
  const CornerNormal corner(triangle.a, triangle.b, triangle.c);
  if (!corner.normal.isZero(0)) normals.push_back(normalized(corner.normal));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector edge = vertices[(i + 1) % 3] - vertices[i];
    if (!edge.isZero(0)) edges.push_back(normalized(edge));
  }
}

Hull about_origin(const Box& box) { return Hull(Box(Point::Zero(), box.r, box.s, box.t)); }

Hull seen_from(const Point& origin, Hull hull) {
  for (Point& vertex : hull.vertices) vertex -= origin;
  return hull;
}

std::vector<Vector> separating_axes(const Hull& a, const Hull& b) {
  std::vector<Vector> axes = a.normals;
  axes.insert(axes.end(), b.normals.begin(), b.normals.end());
  const auto add = [&](const Vector& across) {
    if (norm(across) > parallel_axes) axes.push_back(normalized(across));
  };
  for (const Vector& e : a.edges)
    for (const Vector& f : b.edges) add(e.cross(f));
  if (!a.flat || !b.flat) return axes;

  // Both may lie in one plane, or on one line: then also directions within it, at right angles to an edge.
  const std::vector<Vector> planes = axes;
  for (const Hull* hull : {&a, &b})
    for (const Vector& edge : hull->edges) {
      axes.push_back(edge);
      for (const Vector& plane : planes) add(plane.cross(edge));
    }
  return axes;
}

bool overlap(const Hull& a, const Hull& b) { return Encounter(a, Vector::Zero(), b).overlapping(); }

std::optional<Contact> sweep_hull(const Hull& moving, const Vector& displacement, const Hull& obstacle) {
  const Encounter encounter(moving, displacement, obstacle);
  double time = 0;
  const Axis* axis = encounter.overlapping() ? encounter.way_in() : encounter.last_to_meet(time);
  if (!axis || time > 1) return std::nullopt;
  const Vector normal = axis->outward();
  const Point middle =
      shared_middle(moving.vertices, time * displacement, obstacle.vertices, normal, encounter.rounding());
  return Contact{time, only(middle), normal, feature_of(obstacle, normal, encounter.rounding())};
}

}  // namespace first_contact
