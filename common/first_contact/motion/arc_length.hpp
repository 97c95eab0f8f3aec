#pragma once
#include <limits>
#include <utility>
#include <vector>

#include "first_contact/motion/curve.hpp"

namespace first_contact {

/// A curve by its length: a tween at constant speed. A curve's own parameter is no distance; on a plain arch
/// the speed |dC/du| may well vary by a factor of two.
///
/// Error of every length: at most `relative_error` of the whole length, for every curve: also one that turns
/// back on itself, has a cusp, or stands still at an end.
class ArcLength {
 public:
  /// Measures the curve: the integral of |dC/du| by Gauss's rule on pieces that are halved until it is known
  /// that halving no longer matters. That takes a time that grows like the square of the degree; a curve of
  /// degree 100 takes some milliseconds.
  /// \throws std::invalid_argument if the length is larger than any double.
  explicit ArcLength(Curve curve);

  /// The whole length.
  double total() const { return lengths_.back() * unit_; }
  /// The length from the start to u in [0, 1]; exactly 0 at 0 and total() at 1.
  double to(double u) const;
  /// The u in [0, 1] at that length from the start (one outside [0, total()] counts as the nearer end);
  /// exactly 0 at 0 and 1 at total().
  double parameter(double length) const;
  /// The point at that part of the whole length. Below 0 and above 1 it goes straight on along the end's
  /// tangent; where an end point is there twice, that leads to the next other control point.
  Point at(double part) const;
  /// The curve.
  const Curve& curve() const { return curve_; }

  /// Of a length, at the most.
  static constexpr double relative_error = 1e-12;
  /// What rounding may make of a speed, for each control vector and in units of the fastest: corner cutting
  /// rounds once for each, and a rule, its halves and their sum add a few more. Below that, halving has no
  /// end.
  static constexpr double rounding_of_speed = 8 * std::numeric_limits<double>::epsilon();

 private:
  /// A part of the curve, and the control vectors of its dC/du.
  struct Piece {
    double from, to;
    std::vector<Vector> speeds;

    double length() const;
    std::pair<Piece, Piece> halves() const;
  };
  double speed(double u) const;
  double gauss(double from, double to) const;
  void measure(const Piece& piece);
  static bool goes_one_way(const Piece& piece, double allowed);
  double allowed_in(const Piece& piece) const;
  double length_to(double u) const;
  double parameter_at(double length) const;
  Vector direction_beyond(double end) const;

  Curve curve_, hodograph_;
  double unit_ = 1;                    // of the hodograph, and of these lengths: a power of two
  double allowed_ = 0;                 // error of a piece, divided by the part of u that it takes
  std::vector<double> parameters_{0};  // where the pieces begin and end
  std::vector<double> lengths_{0};     // from the start to there
};

}  // namespace first_contact
