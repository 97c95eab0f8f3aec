#include "first_contact/motion/curve.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

namespace {

void require_control_points(const std::vector<Point>& points, const std::string& what) {
  if (points.empty()) refuse(what, "must have a control point");
  for (std::size_t i = 0; i < points.size(); ++i)
    require_finite(points[i], what + "'s control point " + std::to_string(i));
}

// With this form, unlike a + s (b - a), the ends are exact: a at s = 0 and b at s = 1.
Point between(const Point& a, const Point& b, double s) { return (1 - s) * a + s * b; }

// None where the degree is too high: it is refused by its number, not by the memory that it would need.
std::vector<double> clamped_knots(std::size_t points, std::size_t degree) {
  if (points <= degree) return {};
  std::vector<double> knots(degree, 0.0);
  const std::size_t pieces = points - degree;
  for (std::size_t i = 0; i <= pieces; ++i)
    knots.push_back(static_cast<double>(i) / static_cast<double>(pieces));
  knots.insert(knots.end(), degree, 1.0);
  return knots;
}

}  // namespace

Bezier::Bezier(std::vector<Point> control_points) : control_(std::move(control_points)) {
  require_control_points(control_, "Bezier curve");
}

//! [de_casteljau]
Point Bezier::at(double u) const {
  std::vector<Point> points = control_;
  for (std::size_t left = points.size() - 1; left > 0; --left)  // cut the corners, one fewer each time
    for (std::size_t i = 0; i < left; ++i) points[i] = between(points[i], points[i + 1], u);
  return points.front();
}
//! [de_casteljau]

Bezier Bezier::derivative() const {
  if (degree() == 0) return Bezier({Vector::Zero()});
  std::vector<Vector> differences;
  for (std::size_t i = 0; i < degree(); ++i)
    differences.emplace_back(static_cast<double>(degree()) * (control_[i + 1] - control_[i]));
  require_control_points(differences, "Bezier curve's derivative");
  return Bezier(std::move(differences));
}

// Corner cutting with a value of its own at each level (Ramshaw, Blossoming, 1987): n - k times at `from` and k
// times at `to` it gives control point k of the part between the two.
Bezier Bezier::part(double from, double to) const {
  std::vector<Point> part;
  for (std::size_t k = 0; k <= degree(); ++k) {
    std::vector<Point> points = control_;
    for (std::size_t left = degree(); left > 0; --left)
      for (std::size_t i = 0; i < left; ++i)
        points[i] = between(points[i], points[i + 1], left > k ? from : to);
    part.push_back(points.front());
  }
  return Bezier(std::move(part));
}

Bezier Bezier::elevated() const {
  const auto n = static_cast<double>(control_.size());
  std::vector<Point> points{control_.front()};
  for (std::size_t i = 1; i < control_.size(); ++i)
    points.push_back(between(control_[i], control_[i - 1], static_cast<double>(i) / n));
  points.push_back(control_.back());
  return Bezier(std::move(points));
}

BSpline::BSpline(std::vector<Point> control_points, std::size_t degree)
    : control_(std::move(control_points)), degree_(degree), knots_(clamped_knots(control_.size(), degree)) {
  require_sound();
}

BSpline::BSpline(std::vector<Point> control_points, std::size_t degree, std::vector<double> knots)
    : control_(std::move(control_points)), degree_(degree), knots_(std::move(knots)) {
  require_sound();
}

void BSpline::require_sound() const {
  require_control_points(control_, "B-spline");
  const std::string degree = std::to_string(degree_), points = std::to_string(control_.size());
  if (control_.size() <= degree_)
    refuse("B-spline's " + points + " control points", "must be more than the degree, " + degree);
  if (knots_.size() != control_.size() + degree_ + 1)
    refuse("B-spline's " + std::to_string(knots_.size()) + " knots", "must be control points + degree + 1");
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    const std::string knot = "B-spline's knot " + std::to_string(i);
    if (!std::isfinite(knots_[i])) refuse(knot + ",", knots_[i], "must be finite");
    if (i > 0 && knots_[i] < knots_[i - 1])
      refuse(knot + ",", knots_[i], "must not be less than the one before");
  }
  for (std::size_t i = 1; i < control_.size(); ++i)
    if (degree_ > 0 && !(knots_[i] < knots_[i + degree_]))
      refuse("B-spline's knots from number " + std::to_string(i),
             "must not coincide more often than the degree, " + degree);
  if (!(first() < last()) || !std::isfinite(knots_.back() - knots_.front()))
    refuse("B-spline's knots from " + to_text(knots_.front()) + " to " + to_text(knots_.back()),
           "must span a finite interval");
}

// The piece [knot, next) that holds x; the very end, and what is beyond, belongs to the last of all.
std::size_t BSpline::piece_of(double x) const {
  const auto begin = knots_.begin() + static_cast<std::ptrdiff_t>(degree_);
  const auto end = knots_.begin() + static_cast<std::ptrdiff_t>(control_.size());
  const auto next = x < last() ? std::upper_bound(begin, end, x) : std::lower_bound(begin, end, last());
  return static_cast<std::size_t>(std::max(next - begin, std::ptrdiff_t{1}) - 1) + degree_;
}

//! [de_boor]
Point BSpline::at(double u) const {
  const double x = lerp(first(), last(), u);
  const std::size_t piece = piece_of(x);
  const auto from = control_.begin() + static_cast<std::ptrdiff_t>(piece - degree_);
  std::vector<Point> points(from, from + static_cast<std::ptrdiff_t>(degree_ + 1));
  for (std::size_t left = degree_; left > 0; --left)  // cut the corners, one fewer each time
    for (std::size_t i = 0; i < left; ++i) {
      const double begin = knots_[piece - left + 1 + i], end = knots_[piece + 1 + i];
      points[i] = between(points[i], points[i + 1], (x - begin) / (end - begin));
    }
  return points.front();
}
//! [de_boor]

//! [b_spline_derivative]
BSpline BSpline::derivative() const {
  BSpline hodograph;  // its knots are not checked: where this curve has a corner, its derivative may jump
  hodograph.knots_ = knots_;
  hodograph.control_.assign(control_.size(), Vector::Zero());
  if (degree_ == 0) return hodograph;
  hodograph.degree_ = degree_ - 1;
  hodograph.knots_ = {knots_.begin() + 1, knots_.end() - 1};
  hodograph.control_.pop_back();
  const double scale = static_cast<double>(degree_) * (last() - first());
  for (std::size_t i = 0; i + 1 < control_.size(); ++i) {
    const double support = knots_[i + degree_ + 1] - knots_[i + 1];
    if (support > 0) hodograph.control_[i] = scale / support * (control_[i + 1] - control_[i]);
  }
  require_control_points(hodograph.control_, "B-spline's derivative");
  return hodograph;
}
//! [b_spline_derivative]

std::vector<double> BSpline::breaks() const {
  std::vector<double> values{0};
  for (std::size_t i = degree_ + 1; i < control_.size(); ++i) {
    const double u = parameter_of(knots_[i]);
    if (u > values.back() && u < 1) values.push_back(u);
  }
  values.push_back(1);
  return values;
}

// De Boor's corner cutting with a value of its own at each level: with a and b in some number each, it gives
// the control points of the piece from a to b as a Bezier curve (Ramshaw, Blossoming, 1987).
Point BSpline::blossom(std::size_t piece, double a, double b, std::size_t times_b) const {
  const auto from = control_.begin() + static_cast<std::ptrdiff_t>(piece - degree_);
  std::vector<Point> points(from, from + static_cast<std::ptrdiff_t>(degree_ + 1));
  for (std::size_t left = degree_; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) {
      const double begin = knots_[piece - left + 1 + i], end = knots_[piece + 1 + i];
      points[i] = between(points[i], points[i + 1], ((left > times_b ? a : b) - begin) / (end - begin));
    }
  return points.front();
}

std::vector<Bezier> BSpline::pieces() const {
  std::vector<Bezier> all;
  for (std::size_t i = degree_; i < control_.size(); ++i) {
    if (!(parameter_of(knots_[i]) < parameter_of(knots_[i + 1]))) continue;
    std::vector<Point> points;
    for (std::size_t k = 0; k <= degree_; ++k) points.push_back(blossom(i, knots_[i], knots_[i + 1], k));
    all.emplace_back(std::move(points));
  }
  return all;
}

BSpline BSpline::scaled(double factor) const {
  BSpline result = *this;
  for (Point& p : result.control_) p *= factor;
  require_control_points(result.control_, "B-spline");
  return result;
}

Curve scaled(const Curve& curve, double factor) {
  if (const auto* spline = std::get_if<BSpline>(&curve)) return spline->scaled(factor);
  std::vector<Point> points = control_points(curve);
  for (Point& p : points) p *= factor;
  return Bezier(std::move(points));
}

std::vector<Bezier> bezier_pieces(const Curve& curve) {
  const auto* spline = std::get_if<BSpline>(&curve);
  return spline ? spline->pieces() : std::vector{std::get<Bezier>(curve)};
}

Point at(const Curve& curve, double u) {
  return std::visit([u](const auto& c) { return c.at(u); }, curve);
}

Curve derivative(const Curve& curve) {
  return std::visit([](const auto& c) { return Curve(c.derivative()); }, curve);
}

const std::vector<Point>& control_points(const Curve& curve) {
  return std::visit([](const auto& c) -> const std::vector<Point>& { return c.control_points(); }, curve);
}

std::vector<double> breaks(const Curve& curve) {
  const auto* spline = std::get_if<BSpline>(&curve);
  return spline ? spline->breaks() : std::vector<double>{0, 1};
}

double largest_coordinate(const Curve& curve) {
  double largest = 0;
  for (const Point& p : control_points(curve)) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

double longest_control_vector(const Curve& hodograph) {
  double longest = 0;
  for (const Vector& v : control_points(hodograph)) longest = std::max(longest, norm(v));
  return longest;
}

}  // namespace first_contact
