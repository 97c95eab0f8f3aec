#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "first_contact/geometry/space.hpp"

/// \file
/// The hit tests of ActionScript 3 (paper, 1.1 and 2.4.1), from what its documents say of them: hitTestPoint,
/// a point against an object's shape or its bounding box, and hitTestObject, bounding box against bounding
/// box.
///
/// - Points are given on the *stage*, the one space that all objects share; each object has an outline of its
///   own, and a transform that puts it on the stage. To take a point in the object's own coordinates is the
///   common mistake.
/// - A shape is filled by the even-odd rule: a point is inside if a ray from it crosses the outline an odd
///   number of times. Where an outline crosses itself there may be holes.
/// - The boundary belongs to the shape, and the sides to the box: touching is a hit.
/// - An object without corners is hit by nothing.

namespace first_contact {

/// A point of the stage.
using Point2 = Vector2;

/// An upright rectangle of the stage, its sides included; at first of nothing.
struct Rectangle {
  /// Grows until it contains the point.
  void include(const Point2& point);
  /// Is the point in it?
  bool contains(const Point2& point) const;
  /// What it shares with another; of nothing if they are apart.
  Rectangle common(const Rectangle& other) const;
  /// Is it of nothing?
  bool empty() const { return !(low.x() <= high.x() && low.y() <= high.y()); }

  /// The corner with the smallest coordinates.
  Point2 low = Point2::Constant(std::numeric_limits<double>::infinity());
  /// The corner with the largest coordinates.
  Point2 high = Point2::Constant(-std::numeric_limits<double>::infinity());
};

/// A flat object on a stage: a closed polygon, convex or not.
class StageObject {
 public:
  /// \param outline  the corners in the object's own coordinates; the last is joined to the first
  /// \param to_stage  where and how it stands on the stage
  /// \throws std::invalid_argument if a corner, as it comes to stand on the stage, is not finite
  explicit StageObject(std::span<const Point2> outline,
                       const Eigen::Affine2d& to_stage = Eigen::Affine2d::Identity());

  /// The corners on the stage.
  const std::vector<Point2>& outline() const { return outline_; }
  /// The smallest box on the stage, its sides along the axes, that holds the outline.
  const Rectangle& bounding_box() const { return box_; }

 private:
  std::vector<Point2> outline_;
  Rectangle box_;
};

/// How far from a side a point still counts as on it, in units of the largest coordinate of that side and the
/// point: twice the rounding of the cross product that decides it, which is below 4 eps.
inline constexpr double boundary_tolerance = 0x1p-49;  // 8 eps

/// hitTestPoint(x, y, shapeFlag): is the point of the stage in the object's bounding box or, if `shape_flag`,
/// in its shape?
bool hit_test_point(const StageObject& object, const Point2& on_stage, bool shape_flag = false);

/// hitTestObject(other): do the bounding boxes share a point? Their shapes may well be apart.
bool hit_test_object(const StageObject& a, const StageObject& b);

/// What hitTestObject cannot tell: do the shapes themselves share a point? Two sides meet, or a corner of one
/// is inside the other.
bool overlap(const StageObject& a, const StageObject& b);

/// The object under the pointer (paper, 3.2.4): of all whose shape it is in, the one drawn last, on top of
/// the others. Nothing if there is none.
std::optional<std::size_t> pick(std::span<const StageObject> drawn, const Point2& pointer);

}  // namespace first_contact
