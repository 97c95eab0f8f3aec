#include "first_contact/stage/hit_test.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

struct Side {
  Point2 from, to;
};

std::vector<Side> sides_of(const StageObject& object) {
  std::vector<Side> sides;
  const auto& outline = object.outline();
  for (std::size_t i = 0; i < outline.size(); ++i)
    sides.push_back({outline[i], outline[(i + 1) % outline.size()]});
  return sides;
}

double largest(const Side& side, const Point2& p) {
  return std::max({side.from.cwiseAbs().maxCoeff(), side.to.cwiseAbs().maxCoeff(), p.cwiseAbs().maxCoeff()});
}

// How far from this side a point counts as on it.
double rounding_at(const Side& side, const Point2& p) { return boundary_tolerance * largest(side, p); }

// Left of the side, seen along it: 1; right of it: -1; on its line, up to rounding: 0.
int turn(const Side& side, const Point2& point) {
  const double scale = unit_scale(largest(side, point));  // products of any coordinates are ordinary then
  const Point2 from = scale * side.from, to = scale * side.to, p = scale * point;
  const Point2 along = to - from, m = p - from;
  const double cross = along.x() * m.y() - along.y() * m.x();  // |along| times the distance from the line
  return std::abs(cross) <= rounding_at({from, to}, p) * (std::abs(along.x()) + std::abs(along.y())) ? 0
         : cross > 0                                                                                 ? 1
                                                                                                     : -1;
}

bool on(const Side& side, const Point2& p) {
  if (turn(side, p) != 0) return false;
  const Point2 margin = Point2::Constant(rounding_at(side, p));
  return Rectangle{side.from.cwiseMin(side.to) - margin, side.from.cwiseMax(side.to) + margin}.contains(p);
}

// Does the ray from p to the right cross a side that p is not on? Of the side's two ends the upper one does
// not count, so that a ray through a corner crosses once, or twice, or not at all, as it should.
bool ray_crosses(const Side& side, const Point2& p) {
  const bool upward = side.from.y() <= p.y() && p.y() < side.to.y();
  const bool downward = side.to.y() <= p.y() && p.y() < side.from.y();
  if (!upward && !downward) return false;
  if (p.x() < std::min(side.from.x(), side.to.x())) return true;
  if (p.x() > std::max(side.from.x(), side.to.x())) return false;
  return turn(side, p) == (upward ? 1 : -1);
}

bool meet(const Side& a, const Side& b) {
  if (on(a, b.from) || on(a, b.to) || on(b, a.from) || on(b, a.to)) return true;
  return turn(a, b.from) * turn(a, b.to) < 0 && turn(b, a.from) * turn(b, a.to) < 0;
}

}  // namespace

void Rectangle::include(const Point2& point) {
  low = low.cwiseMin(point);
  high = high.cwiseMax(point);
}

bool Rectangle::contains(const Point2& point) const {
  return (low.array() <= point.array()).all() && (point.array() <= high.array()).all();
}

Rectangle Rectangle::common(const Rectangle& other) const {
  return {low.cwiseMax(other.low), high.cwiseMin(other.high)};
}

StageObject::StageObject(std::span<const Point2> outline, const Eigen::Affine2d& to_stage) {
  const Eigen::Matrix3d& m = to_stage.matrix();
  const auto stand = [&](const Point2& p) {
    return Point2(m(0, 0) * p.x() + m(0, 1) * p.y() + m(0, 2), m(1, 0) * p.x() + m(1, 1) * p.y() + m(1, 2));
  };
  for (const Point2& corner : outline) {
    outline_.push_back(stand(corner));
    box_.include(outline_.back());
    if (outline_.back().allFinite()) continue;
    refuse("outline's corner " + to_text(corner.x()) + ", " + to_text(corner.y()),
           "must be finite on the stage");
  }
}

//! [hit_test_point]
bool hit_test_point(const StageObject& object, const Point2& on_stage, bool shape_flag) {
  if (!object.bounding_box().contains(on_stage)) return false;
  if (!shape_flag) return true;
  bool inside = false;
  for (const Side& side : sides_of(object)) {
    if (on(side, on_stage)) return true;
    if (ray_crosses(side, on_stage)) inside = !inside;
  }
  return inside;
}
//! [hit_test_point]

//! [hit_test_object]
bool hit_test_object(const StageObject& a, const StageObject& b) {
  return !a.bounding_box().common(b.bounding_box()).empty();
}
//! [hit_test_object]

//! [overlap_shapes]
bool overlap(const StageObject& a, const StageObject& b) {
  if (!hit_test_object(a, b)) return false;  // the quick test first
  for (const Side& side_a : sides_of(a))
    for (const Side& side_b : sides_of(b))
      if (meet(side_a, side_b)) return true;
  return hit_test_point(a, b.outline().front(), true) || hit_test_point(b, a.outline().front(), true);
}
//! [overlap_shapes]

//! [pick]
std::optional<std::size_t> pick(std::span<const StageObject> drawn, const Point2& pointer) {
  for (std::size_t i = drawn.size(); i-- > 0;)
    if (hit_test_point(drawn[i], pointer, true)) return i;
  return std::nullopt;
}
//! [pick]

}  // namespace first_contact
