#pragma once
#include <optional>
#include <vector>

#include "first_contact/motion/arc_length.hpp"
#include "first_contact/motion/curve.hpp"
#include "first_contact/motion/through_points.hpp"

/// \file
/// The way from one key frame to the next: what the animator says of it, and the curve that it becomes.

namespace first_contact {

/// The way from one key frame to the next. Its ends are the two key positions, so that no path can miss them.
struct Path {
  /// What leads from one to the next.
  enum class Kind { straight, bezier, b_spline, hermite, through, legs };

  /// Which of them.
  Kind kind = Kind::straight;
  /// Between the two key positions: control points, points to pass through, or the joints of several legs; of a
  /// Hermite curve its two velocities.
  std::vector<Point> between;
  bool constant_speed = false;       ///< by arc length instead of the curve's own parameter
  Knots knots = Knots::centripetal;  ///< of a path through points
  std::vector<Path> parts = {};      ///< of several legs

  /// A Bezier curve; its degree follows from the number of points.
  static Path bezier(std::vector<Point> points, bool by_length = false);
  /// Clamped, cubic (of a lower degree if there are fewer than two points between).
  static Path b_spline(std::vector<Point> points, bool by_length = false);
  /// Cubic, with these velocities dC/du at its two ends.
  static Path hermite(const Vector& leaving, const Vector& arriving, bool by_length = false);
  /// Through these points, in this order (catmull_rom).
  static Path through(std::vector<Point> points, bool by_length = false, Knots knots = Knots::centripetal);
  /// Several legs with one easing, and, if by_length, one speed: leg i ends at joint i, the last one at the key.
  /// Whether a leg by itself has a constant speed does not matter.
  /// \throws std::invalid_argument if there is not one leg more than there are joints.
  static Path of_legs(std::vector<Path> legs, std::vector<Point> joints, bool by_length = true);

  /// The curve from a to b.
  /// \throws std::invalid_argument as the curve's own kind does.
  Curve from_to(const Point& a, const Point& b) const;
};

/// A piece of the way, as one polynomial or one line.
struct Stretch {
  Bezier curve;  ///< the piece, in the direction in which it is gone along
  ///@{
  /// The parameter of the whole curve at its beginning and its end; beyond [0, 1] also.
  double from, to;
  ///@}
};

/// A path with its two ends: the place at each part of the way.
class Leg {
 public:
  /// \throws std::invalid_argument as the path's curve and its ArcLength do.
  Leg(const Path& path, const Point& a, const Point& b);

  /// The place at that part of the way: a at 0 and b at 1. Beyond, where an easing overshoots, a curve by its own
  /// parameter goes on as its polynomial does, one by its length straight on.
  Point at(double part) const;
  /// The way from one part to another, either of which may be beyond an end, piece by piece.
  std::vector<Stretch> stretches(double from_part, double to_part) const;
  /// The part of the way at a parameter of the curve.
  double part(double u) const;
  /// The parameter of the curve at that part of the way; beyond the ends they are the same.
  double parameter(double part) const;
  /// Its curve.
  const Curve& curve() const { return curve_; }
  /// The same by its length, if its speed is constant.
  const std::optional<ArcLength>& by_length() const { return by_length_; }

 private:
  Curve curve_;
  std::optional<ArcLength> by_length_;
};

}  // namespace first_contact
