#include "first_contact/motion/arc_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

// Nodes and weights of Gauss's rule with eight points on [-1, 1], the positive half (Abramowitz and Stegun,
// 25.4): exact for polynomials up to degree 15.
constexpr std::array<double, 4> nodes{0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                      0.96028985649753623};
constexpr std::array<double, 4> weights{0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                        0.10122853629037626};

template <class Function>
double gauss_sum(const Function& speed, double from, double to) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    sum += weights[i] * (speed(middle - half * nodes[i]) + speed(middle + half * nodes[i]));
  return half * sum;
}

// In a unit in which no square leaves the range of double. The coordinates are brought to about 1 first: dC/du is
// longer than they are, by the degree, and where knots are close together by much more.
std::pair<Curve, double> hodograph_in_unit(const Curve& curve) {
  const double before = unit_scale(largest_coordinate(curve));
  const Curve slope = derivative(scaled(curve, before));
  const double after = unit_scale(largest_coordinate(slope));
  return {scaled(slope, after), 1 / after / before};
}

}  // namespace

ArcLength::ArcLength(Curve curve) : curve_(std::move(curve)), hodograph_(curve_) {
  std::tie(hodograph_, unit_) = hodograph_in_unit(curve_);
  const std::vector<double> joints = breaks(curve_);
  const std::vector<Bezier> parts = bezier_pieces(hodograph_);
  double rough = 0;
  for (std::size_t i = 1; i < joints.size(); ++i) rough += gauss(joints[i - 1], joints[i]);
  allowed_ = relative_error / 16 * rough;
  for (std::size_t i = 1; i < joints.size(); ++i)
    measure({joints[i - 1], joints[i], parts[i - 1].control_points()});
  if (!std::isfinite(total())) refuse("curve's length", total(), "must be finite");
}

double ArcLength::Piece::length() const {
  const Bezier hodograph(speeds);
  return (to - from) * gauss_sum([&](double s) { return norm(hodograph.at(s)); }, 0, 1);
}

double ArcLength::speed(double u) const { return norm(first_contact::at(hodograph_, u)); }

double ArcLength::gauss(double from, double to) const {
  return gauss_sum([this](double u) { return speed(u); }, from, to);
}

//! [arc_length]
// Two halves are measured far better than the whole (by 2^16 where the speed is smooth): their difference
// bounds the error. The halves are kept as pieces, so that later a part of a piece needs one more rule alone.
void ArcLength::measure(const Piece& piece) {
  const auto [left, right] = piece.halves();
  const double allowed = allowed_in(piece);
  if (goes_one_way(piece, allowed)) {
    const double left_length = left.length(), both = left_length + right.length();
    if (!(std::abs(both - piece.length()) > allowed * (piece.to - piece.from))) {
      parameters_.insert(parameters_.end(), {left.to, right.to});
      lengths_.push_back(lengths_.back() + left_length);
      lengths_.push_back(lengths_.end()[-2] + both);
      return;
    }
  }
  measure(left);
  measure(right);
}

// The difference may be small by chance, where the speed has a corner between the points of the rule: that is
// where a straight curve turns back. So it must also be known that there is none, since dC/du, which is in
// the hull of its control vectors, keeps to one direction by and large. Or the piece is so nearly straight,
// or so short, that it does not matter: its length is between its chord and its control polygon.
bool ArcLength::goes_one_way(const Piece& piece, double allowed) {
  const auto count = static_cast<double>(piece.speeds.size());
  Vector mean = Vector::Zero();
  double polygon = 0, deviation = 0;
  for (const Vector& v : piece.speeds) mean += v / count;
  for (const Vector& v : piece.speeds) {
    polygon += norm(v) / count;
    deviation = std::max(deviation, norm(v - mean));
  }
  const double chord = norm(mean);
  return deviation <= chord / 2 || !(polygon - chord > allowed);
}
//! [arc_length]

double ArcLength::allowed_in(const Piece& piece) const {
  double fastest = 0;
  for (const Vector& v : piece.speeds) fastest = std::max(fastest, norm(v));
  return std::max(allowed_, rounding_of_speed * static_cast<double>(piece.speeds.size()) * fastest);
}

std::pair<ArcLength::Piece, ArcLength::Piece> ArcLength::Piece::halves() const {
  const double middle = 0.5 * (from + to);
  Piece left{from, middle, {}}, right{middle, to, speeds};
  for (std::size_t left_over = speeds.size(); left_over > 0; --left_over) {
    left.speeds.push_back(right.speeds.front());
    for (std::size_t i = 0; i + 1 < left_over; ++i)
      right.speeds[i] = 0.5 * right.speeds[i] + 0.5 * right.speeds[i + 1];
  }
  return {left, right};
}

double ArcLength::to(double u) const {
  if (!(u > 0)) return 0;
  return u >= 1 ? total() : length_to(u) * unit_;
}

double ArcLength::length_to(double u) const {
  const auto next = std::upper_bound(parameters_.begin(), parameters_.end(), u);
  const auto piece = static_cast<std::size_t>(next - parameters_.begin()) - 1;
  return std::clamp(lengths_[piece] + gauss(parameters_[piece], u), lengths_[piece], lengths_[piece + 1]);
}

double ArcLength::parameter(double length) const {
  if (!(length > 0)) return 0;
  return length >= total() ? 1 : parameter_at(length / unit_);
}

//! [arc_length_parameter]
// Newton's steps, u += (s - length) / speed, kept within the bracket that they shrink; halving where they
// leave it.
double ArcLength::parameter_at(double length) const {
  const auto next = std::upper_bound(lengths_.begin(), lengths_.end(), length);
  const auto piece = static_cast<std::size_t>(next - lengths_.begin()) - 1;
  double low = parameters_[piece], high = parameters_[piece + 1];
  const double part = (length - lengths_[piece]) / (lengths_[piece + 1] - lengths_[piece]);
  double u = lerp(low, high, part);
  for (int step = 0; step < 100; ++step) {
    const double missing = length - length_to(u);
    (missing > 0 ? low : high) = u;
    const double wished = u + missing / speed(u);
    const double better = wished > low && wished < high ? wished : 0.5 * (low + high);
    if (std::abs(missing) <= allowed_ || better == u) break;
    u = better;
  }
  return u;
}
//! [arc_length_parameter]

// Where the curve stands still at its end, it leaves along the first control vector that is not zero.
Vector ArcLength::direction_beyond(double end) const {
  const Vector tangent = first_contact::at(hodograph_, end);
  if (!tangent.isZero(0)) return normalized(tangent);
  std::vector<Vector> speeds = control_points(hodograph_);
  if (end == 1) std::reverse(speeds.begin(), speeds.end());
  const auto first = std::find_if(speeds.begin(), speeds.end(), [](const Vector& v) { return !v.isZero(0); });
  return first != speeds.end() ? normalized(*first) : tangent;
}

Point ArcLength::at(double part) const {
  const double inside = std::clamp(part, 0.0, 1.0);
  if (part != inside)
    return first_contact::at(curve_, inside) + (part - inside) * total() * direction_beyond(inside);
  return first_contact::at(curve_, parameter(part * total()));
}

}  // namespace first_contact
