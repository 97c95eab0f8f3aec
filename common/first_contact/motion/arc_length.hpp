#pragma once
#include <vector>

#include "first_contact/motion/curve.hpp"

namespace first_contact {

/// A curve by its length: a tween at constant speed. A curve's own parameter is no distance; on a plain arch
/// the speed |dC/du| may well vary by a factor of two.
///
/// Error of every length: at most `relative_error` of the whole length.
class ArcLength {
 public:
  /// Measures the curve: the integral of |dC/du| by Gauss's rule on pieces that are halved until halving no
  /// longer matters.
  explicit ArcLength(Curve curve);

  /// The whole length.
  double total() const { return lengths_.back(); }
  /// The length from the start to u in [0, 1]; exactly 0 at 0 and total() at 1.
  double to(double u) const;
  /// The u in [0, 1] at that length from the start (one outside [0, total()] counts as the nearer end);
  /// exactly 0 at 0 and 1 at total().
  double parameter(double length) const;
  /// The point at that part of the whole length. Below 0 and above 1 it goes straight on along the end's
  /// tangent.
  Point at(double part) const;
  /// The curve.
  const Curve& curve() const { return curve_; }

  /// Of a length, at the most.
  static constexpr double relative_error = 1e-12;

 private:
  double speed(double u) const { return first_contact::at(hodograph_, u).norm(); }
  double gauss(double from, double to) const;
  void measure(double from, double to, double estimate, double allowed, int halvings);

  Curve curve_, hodograph_;
  std::vector<double> parameters_{0};  // where the pieces begin and end
  std::vector<double> lengths_{0};     // from the start to there
};

}  // namespace first_contact
