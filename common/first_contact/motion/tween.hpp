#pragma once
#include <optional>
#include <vector>

#include "first_contact/geometry/transform.hpp"
#include "first_contact/motion/arc_length.hpp"
#include "first_contact/motion/curve.hpp"
#include "first_contact/motion/easing.hpp"

/// \file
/// Tweening (paper, 1.1): the animator gives the key frames, the program what is in between.

namespace first_contact {

/// The way from one key frame to the next. Its ends are the two key positions, so that no path can miss them.
struct Path {
  /// What leads from one to the next.
  enum class Kind { straight, bezier, b_spline };

  /// Which of them.
  Kind kind = Kind::straight;
  std::vector<Point> between;   ///< control points between the two key positions
  bool constant_speed = false;  ///< by arc length instead of the curve's own parameter

  /// A Bezier curve; its degree follows from the number of points.
  static Path bezier(std::vector<Point> points, bool by_length = false);
  /// Clamped, cubic (of a lower degree if there are fewer than two points between).
  static Path b_spline(std::vector<Point> points, bool by_length = false);
  /// The curve from a to b.
  Curve from_to(const Point& a, const Point& b) const;
};

/// A place at a time, and how to go on from there to the next key frame. Those of the last key frame are not
/// used.
struct KeyFrame {
  double time;                   ///< later than that of the key frame before
  Point position;                ///< at that time
  Easing easing = ease::linear;  ///< of the way to the next
  Path path = {};                ///< to the next
};

/// A motion through key frames. At each key's time it is exactly at its position; before the first and after
/// the last it stays there.
class Tween {
 public:
  /// \throws std::invalid_argument if there is no key frame, a time is not finite or not later than the one
  ///     before, a position or control point is not finite, or an easing is missing.
  explicit Tween(std::vector<KeyFrame> keys);

  /// Where it is at that time.
  Point at(double time) const;
  /// The time of the first key frame.
  double begin() const { return keys_.front().time; }
  /// The time of the last.
  double end() const { return keys_.back().time; }
  /// As they were given.
  const std::vector<KeyFrame>& keys() const { return keys_; }
  /// The curve from key i to key i + 1.
  const Curve& curve(std::size_t i) const { return legs_[i].curve; }

 private:
  struct Leg {
    Curve curve;
    std::optional<ArcLength> by_length;
  };

  std::vector<KeyFrame> keys_;
  std::vector<Leg> legs_;
};

/// A pose of a rigid body at a time.
struct Pose {
  double time;                   ///< later than that of the pose before
  Point position;                ///< of the body's origin
  Quaternion orientation;        ///< of any length but 0
  Easing easing = ease::linear;  ///< of the way to the next
};

/// A rigid motion through key poses: straight lines for the position, and for the orientation the shortest
/// turn at constant angular speed (Shoemake's slerp). Every pose in between is a rigid motion again, a 4x4
/// homogeneous matrix (paper, 2.4.2): it turns and moves and never shears, as tweening the entries of two
/// matrices would.
class RigidTween {
 public:
  /// Orientations are divided by their length.
  /// \throws std::invalid_argument as Tween does, and if an orientation is zero or not finite.
  explicit RigidTween(std::vector<Pose> poses);

  /// The motion from the origin to the pose of that time.
  Rigid at(double time) const;

 private:
  std::vector<Pose> poses_;
};

}  // namespace first_contact
