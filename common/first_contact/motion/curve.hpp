#pragma once
#include <cstddef>
#include <variant>
#include <vector>

#include "first_contact/geometry/space.hpp"

/// \file
/// The curves along which animations are tweened (paper, 1.1): a line, a Bezier curve, a B-spline. Each runs
/// over u in [0, 1], stays within the convex hull of its control points (to within rounding), and its
/// derivative is a curve of the same kind.

namespace first_contact {

/// A Bezier curve of any degree: one less than it has control points. It begins at the first and ends at the
/// last, exactly. With two control points it is a line.
class Bezier {
 public:
  /// \throws std::invalid_argument if there is no control point, or one is not finite.
  explicit Bezier(std::vector<Point> control_points);

  /// The point at u, by de Casteljau's corner cutting. Outside [0, 1] the polynomial goes on.
  Point at(double u) const;
  /// dC/du: the curve of degree one less whose control points are the differences n (P[i+1] - P[i]).
  /// \throws std::invalid_argument if one of them is larger than `largest_length`.
  Bezier derivative() const;
  /// The part of it from u = `from` to u = `to`, as a curve over [0, 1]: backwards if `to` is less, and beyond its
  /// ends as the polynomial goes on.
  Bezier part(double from, double to) const;
  /// The same curve with one control point more.
  Bezier elevated() const;
  /// What leads it.
  const std::vector<Point>& control_points() const { return control_; }
  /// Of its polynomials.
  std::size_t degree() const { return control_.size() - 1; }

 private:
  std::vector<Point> control_;
};

/// A B-spline: pieces of one degree that join at knots. Each piece depends on degree + 1 control points
/// alone, so that moving one of them bends the curve only nearby.
class BSpline {
 public:
  /// Clamped, with equal knot spans: it begins at the first control point and ends at the last, exactly.
  /// \throws std::invalid_argument if there are not more control points than the degree, or one is not
  ///     finite.
  BSpline(std::vector<Point> control_points, std::size_t degree);

  /// With given knots, one for each control point and degree + 1 more; the curve runs from knot number
  /// `degree` to the last but `degree`. It meets its end points only where degree knots or more coincide
  /// there.
  /// \throws std::invalid_argument also if the knots are not finite, not ascending, their number is wrong, or
  ///     more than `degree` of those between the first and the last coincide (the curve would break there).
  BSpline(std::vector<Point> control_points, std::size_t degree, std::vector<double> knots);

  /// The point at u, by de Boor's corner cutting. Outside [0, 1] the polynomial of the nearer piece goes on.
  Point at(double u) const;
  /// dC/du. At a knot where the direction jumps, it is that of the piece which begins there.
  /// \throws std::invalid_argument if a control vector of it is larger than `largest_length`.
  BSpline derivative() const;
  /// What leads it.
  const std::vector<Point>& control_points() const { return control_; }
  /// The knots, ascending.
  const std::vector<double>& knots() const { return knots_; }
  /// Of its polynomials.
  std::size_t degree() const { return degree_; }
  /// The values of u at which the pieces join, with 0 and 1, ascending.
  std::vector<double> breaks() const;
  /// The pieces between them.
  std::vector<Bezier> pieces() const;
  /// Each control point multiplied by a factor.
  /// \throws std::invalid_argument if one of them is then not finite.
  BSpline scaled(double factor) const;

 private:
  BSpline() = default;
  void require_sound() const;
  double first() const { return knots_[degree_]; }
  double last() const { return knots_[control_.size()]; }
  double parameter_of(double knot) const { return (knot - first()) / (last() - first()); }
  std::size_t piece_of(double x) const;
  Point blossom(std::size_t piece, double a, double b, std::size_t times_b) const;

  std::vector<Point> control_;
  std::size_t degree_ = 0;
  std::vector<double> knots_;
};

/// Any of them.
using Curve = std::variant<Bezier, BSpline>;

/// The straight line from a to b, at constant speed.
inline Bezier line(const Point& a, const Point& b) { return Bezier({a, b}); }

/// The same for whichever curve it is.
Point at(const Curve& curve, double u);
/// dC/du.
Curve derivative(const Curve& curve);
/// What leads it.
const std::vector<Point>& control_points(const Curve& curve);
/// The values of u between which the curve is one polynomial, with 0 and 1, ascending.
std::vector<double> breaks(const Curve& curve);

/// The same curve, each control point multiplied by a factor.
/// \throws std::invalid_argument if one of them is then not finite.
Curve scaled(const Curve& curve, double factor);
/// The curve, from each of its `breaks` to the next, as Bezier curves.
std::vector<Bezier> bezier_pieces(const Curve& curve);

/// The largest coordinate of a control point, without its sign.
double largest_coordinate(const Curve& curve);

/// No longer than this is any vector of the curve's hodograph: the curve stays in the hull of its control
/// points.
double longest_control_vector(const Curve& hodograph);

}  // namespace first_contact
