#pragma once
#include <cstddef>
#include <vector>

#include "first_contact/geometry/transform.hpp"
#include "first_contact/motion/easing.hpp"
#include "first_contact/motion/path.hpp"

namespace first_contact {

/// A pose of a rigid body at a time, and how to go on from there to the next pose.
struct Pose {
  double time;                   ///< later than that of the pose before
  Point position;                ///< of the body's origin
  Quaternion orientation;        ///< of any length but 0
  Easing easing = ease::linear;  ///< of the way to the next
  Path path = {};                ///< of the body's origin, to the next
};

/// How far the entries of a rotation may be off: the sums of products of two of its columns, which should be 0 and 1.
/// It is that of a box's axes: what numbers typed with seven digits have.
inline constexpr double rotation_tolerance = 1e-6;

/// The pose of a 4x4 homogeneous matrix (paper, 2.4.2 i): how it turns and where it moves the origin to.
/// \throws std::invalid_argument if the matrix is not a rigid motion: if its last row is not [0, 0, 0, 1], or the
///     rest of it stretches, shears or mirrors by more than `rotation_tolerance`.
Pose pose(double time, const Matrix& matrix, const Easing& easing = ease::linear, const Path& path = {});

/// A turn about an axis through the origin.
struct Turn {
  Vector axis;   ///< unit; any, if it does not turn
  double angle;  ///< in radians, from 0 to pi; anticlockwise as seen from the axis' tip
};

/// A rigid motion through key poses: for the position, straight lines or other paths, and for the orientation the
/// shortest turn at constant angular speed (Shoemake's slerp). Every pose in between is a rigid motion again, a 4x4
/// homogeneous matrix (paper, 2.4.2): it turns and moves and never shears, as tweening the entries of two
/// matrices would. Both go on together, by the part of the way that the easing says.
class RigidTween {
 public:
  /// Orientations are divided by their length.
  /// \throws std::invalid_argument as Tween does, and if an orientation is zero or not finite.
  explicit RigidTween(std::vector<Pose> poses);

  /// The motion from the origin to the pose of that time.
  Rigid at(double time) const;
  /// The same as a 4x4 matrix.
  Matrix matrix(double time) const { return at(time).transform().matrix(); }
  /// The time of the first pose.
  double begin() const { return poses_.front().time; }
  /// The time of the last.
  double end() const { return poses_.back().time; }
  /// As they were given, but for the lengths of the orientations.
  const std::vector<Pose>& poses() const { return poses_; }
  /// The way of the body's origin from each pose to the next.
  const std::vector<Leg>& legs() const { return legs_; }
  /// How it turns from pose i to pose i + 1.
  Turn turn(std::size_t i) const;

 private:
  std::vector<Pose> poses_;
  std::vector<Leg> legs_;
};

}  // namespace first_contact
