#include "first_contact/motion/path.hpp"

#include <algorithm>
#include <utility>

#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

namespace {

std::vector<Point> with_ends(const Point& a, const std::vector<Point>& between, const Point& b) {
  std::vector<Point> points{a};
  points.insert(points.end(), between.begin(), between.end());
  points.push_back(b);
  return points;
}

// The pieces of a curve meet but for a rounding; here they meet exactly.
void append(std::vector<Bezier>& row, const Bezier& piece) {
  std::vector<Point> points = piece.control_points();
  if (!row.empty()) points.front() = row.back().control_points().back();
  row.emplace_back(std::move(points));
}

Curve in_a_row(const std::vector<Path>& parts, const std::vector<Point>& corners) {
  std::vector<Bezier> row;
  std::vector<double> spans;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Curve leg = parts[i].from_to(corners[i], corners[i + 1]);
    for (const Bezier& piece : bezier_pieces(leg)) append(row, piece);
    const std::vector<double> joints = breaks(leg);
    for (std::size_t k = 1; k < joints.size(); ++k) spans.push_back(joints[k] - joints[k - 1]);
  }
  return joined(row, spans);
}

}  // namespace

Path Path::bezier(std::vector<Point> points, bool by_length) {
  return {Kind::bezier, std::move(points), by_length};
}
Path Path::b_spline(std::vector<Point> points, bool by_length) {
  return {Kind::b_spline, std::move(points), by_length};
}
Path Path::hermite(const Vector& leaving, const Vector& arriving, bool by_length) {
  return {Kind::hermite, {leaving, arriving}, by_length};
}
Path Path::through(std::vector<Point> points, bool by_length, Knots knots) {
  return {Kind::through, std::move(points), by_length, knots};
}
Path Path::of_legs(std::vector<Path> legs, std::vector<Point> joints, bool by_length) {
  if (legs.size() != joints.size() + 1)
    refuse("path's legs", "must be one more than the joints between them");
  return {Kind::legs, std::move(joints), by_length, Knots::centripetal, std::move(legs)};
}

Curve Path::from_to(const Point& a, const Point& b) const {
  if (kind == Kind::straight) return line(a, b);
  if (kind == Kind::hermite) return first_contact::hermite(a, between.front(), b, between.back());
  std::vector<Point> points = with_ends(a, between, b);
  if (kind == Kind::bezier) return Bezier(std::move(points));
  if (kind == Kind::through) return catmull_rom(points, knots);
  if (kind == Kind::legs) return in_a_row(parts, points);
  const std::size_t degree = std::min<std::size_t>(3, points.size() - 1);
  return BSpline(std::move(points), degree);
}

Leg::Leg(const Path& path, const Point& a, const Point& b) : curve_(path.from_to(a, b)) {
  if (path.constant_speed) by_length_.emplace(curve_);
  if (by_length_ && by_length_->total() == 0) by_length_.reset();  // nowhere to be fast or slow
}

double Leg::part(double u) const {
  return by_length_ && u > 0 && u < 1 ? by_length_->to(u) / by_length_->total() : u;
}

double Leg::parameter(double part) const {
  return by_length_ && part > 0 && part < 1 ? by_length_->parameter(part * by_length_->total()) : part;
}

std::vector<Stretch> Leg::stretches(double from_part, double to_part) const {
  const std::vector<double> joints = breaks(curve_);
  const std::vector<Bezier> pieces = bezier_pieces(curve_);
  const double from = parameter(std::min(from_part, to_part)), to = parameter(std::max(from_part, to_part));
  std::vector<double> cuts{from};
  for (const double joint : joints)
    if (joint > from && joint < to) cuts.push_back(joint);
  cuts.push_back(to);
  if (to_part < from_part) std::reverse(cuts.begin(), cuts.end());
  std::vector<Stretch> all;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double a = cuts[i - 1], b = cuts[i], middle = lerp(a, b, 0.5);
    if (by_length_ && (middle < 0 || middle > 1)) {
      all.push_back({line(at(a), at(b)), a, b});
      continue;
    }
    const auto next = std::upper_bound(joints.begin() + 1, joints.end() - 1, middle) - joints.begin();
    const auto k = static_cast<std::size_t>(next - 1);
    const double span = joints[k + 1] - joints[k];
    all.push_back({pieces[k].part((a - joints[k]) / span, (b - joints[k]) / span), a, b});
  }
  return all;
}

Point Leg::at(double part) const {
  return by_length_ ? by_length_->at(part) : first_contact::at(curve_, part);
}

}  // namespace first_contact
