#include "first_contact/motion/through_points.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

namespace {

double knot_span(double chord, Knots knots) {
  return knots == Knots::uniform ? 1 : knots == Knots::chordal ? chord : std::sqrt(chord);
}

std::vector<double> knot_spans(std::span<const Point> points, Knots knots) {
  std::vector<double> spans;
  for (std::size_t i = 1; i < points.size(); ++i)
    spans.push_back(knot_span(norm(points[i] - points[i - 1]), knots));
  return spans;
}

//! [velocity_between]
// The velocity, a unit of the knots, in the middle of three points of the parabola through them.
Vector velocity_between(const Vector& before, double span_before, const Vector& after, double span_after) {
  if (span_before == 0 || span_after == 0) return Vector::Zero();
  const double share = span_after / (span_before + span_after);
  return share / span_before * before + (1 - share) / span_after * after;
}
//! [velocity_between]

std::vector<Vector> velocities(std::span<const Point> points, const std::vector<double>& spans) {
  std::vector<Vector> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i, spans.size() - 1);
    all.push_back(velocity_between(points[before + 1] - points[before], spans[before],
                                   points[after + 1] - points[after], spans[after]));
  }
  return all;
}

void require_points_of_curve(std::span<const Point> points) {
  if (points.size() < 2) refuse("curve through points", "must have two points or more");
  for (std::size_t i = 0; i < points.size(); ++i)
    require_finite(points[i], "curve's point " + std::to_string(i));
}

std::vector<double> checked_spans(std::span<const double> spans, std::size_t curves) {
  if (spans.empty()) return std::vector<double>(curves, 1.0);
  if (spans.size() != curves)
    refuse("joined curves' " + std::to_string(spans.size()) + " spans", "must be as many as the curves");
  for (const double span : spans)
    if (!(span > 0) || !std::isfinite(span))
      refuse("joined curves' span", span, "must be positive and finite");
  return {spans.begin(), spans.end()};
}

}  // namespace

Bezier hermite(const Point& a, const Vector& velocity_a, const Point& b, const Vector& velocity_b) {
  return Bezier({a, a + velocity_a / 3, b - velocity_b / 3, b});
}

std::vector<Bezier> catmull_rom_legs(std::span<const Point> points, Knots knots) {
  require_points_of_curve(points);
  const std::vector<double> spans = knot_spans(points, knots);
  const std::vector<Vector> slopes = velocities(points, spans);
  std::vector<Bezier> legs;
  for (std::size_t i = 0; i < spans.size(); ++i)
    legs.push_back(hermite(points[i], spans[i] * slopes[i], points[i + 1], spans[i] * slopes[i + 1]));
  return legs;
}

BSpline catmull_rom(std::span<const Point> points, Knots knots) {
  const std::vector<Bezier> legs = catmull_rom_legs(points, knots);
  std::vector<double> spans = knot_spans(points, knots);
  const double longest = *std::max_element(spans.begin(), spans.end());
  for (double& span : spans)
    if (span == 0) span = longest > 0 ? longest : 1;  // a halt takes some of the parameter
  return joined(legs, spans);
}

BSpline joined(std::span<const Bezier> curves, std::span<const double> spans) {
  if (curves.empty()) refuse("joined curves", "must be one or more");
  const std::vector<double> widths = checked_spans(spans, curves.size());
  std::size_t degree = 1;
  for (const Bezier& curve : curves) degree = std::max(degree, curve.degree());
  std::vector<Point> control{curves.front().control_points().front()};
  std::vector<double> knots(degree + 1, 0.0);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    Bezier curve = curves[i];
    while (curve.degree() < degree) curve = curve.elevated();
    const std::vector<Point>& points = curve.control_points();
    if (points.front() != control.back())
      refuse("joined curve " + std::to_string(i), "must begin where the one before ends");
    control.insert(control.end(), points.begin() + 1, points.end());
    knots.insert(knots.end(), degree, knots.back() + widths[i]);
  }
  knots.push_back(knots.back());
  return {std::move(control), degree, std::move(knots)};
}

}  // namespace first_contact
