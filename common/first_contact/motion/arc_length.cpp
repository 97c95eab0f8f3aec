#include "first_contact/motion/arc_length.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace first_contact {

namespace {

// Nodes and weights of Gauss's rule with eight points on [-1, 1], the positive half (Abramowitz and Stegun,
// 25.4): exact for polynomials up to degree 15.
constexpr std::array<double, 4> nodes{0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                      0.96028985649753623};
constexpr std::array<double, 4> weights{0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                        0.10122853629037626};

// Each halving at a corner or a cusp of the curve quarters the error that is left there: 32 take it below
// rounding.
constexpr int most_halvings = 32;

}  // namespace

ArcLength::ArcLength(Curve curve) : curve_(std::move(curve)), hodograph_(derivative(curve_)) {
  const std::vector<double> joints = breaks(curve_);
  double rough = 0;
  for (std::size_t i = 1; i < joints.size(); ++i) rough += gauss(joints[i - 1], joints[i]);
  for (std::size_t i = 1; i < joints.size(); ++i)
    measure(joints[i - 1], joints[i], gauss(joints[i - 1], joints[i]), relative_error / 16 * rough,
            most_halvings);
}

double ArcLength::gauss(double from, double to) const {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    sum += weights[i] * (speed(middle - half * nodes[i]) + speed(middle + half * nodes[i]));
  return half * sum;
}

//! [arc_length]
// Two halves are measured far better than the whole (by 2^16 where the speed is smooth): their difference
// bounds the error. The halves are kept as pieces, so that later a part of a piece needs one more rule alone.
void ArcLength::measure(double from, double to, double estimate, double allowed, int halvings) {
  const double middle = 0.5 * (from + to);
  const double left = gauss(from, middle), right = gauss(middle, to);
  if (halvings > 0 && std::abs(left + right - estimate) > allowed) {
    measure(from, middle, left, allowed / 2, halvings - 1);
    measure(middle, to, right, allowed / 2, halvings - 1);
    return;
  }
  parameters_.insert(parameters_.end(), {middle, to});
  lengths_.push_back(lengths_.back() + left);
  lengths_.push_back(lengths_.back() + right);
}
//! [arc_length]

double ArcLength::to(double u) const {
  if (!(u > 0)) return 0;
  if (u >= 1) return total();
  const auto next = std::upper_bound(parameters_.begin(), parameters_.end(), u);
  const auto piece = static_cast<std::size_t>(next - parameters_.begin()) - 1;
  return std::clamp(lengths_[piece] + gauss(parameters_[piece], u), lengths_[piece], lengths_[piece + 1]);
}

//! [arc_length_parameter]
// Newton's steps, u += (s - length) / speed, kept within the bracket that they shrink; halving where they
// leave it.
double ArcLength::parameter(double length) const {
  if (!(length > 0)) return 0;
  if (length >= total()) return 1;
  const auto next = std::upper_bound(lengths_.begin(), lengths_.end(), length);
  const auto piece = static_cast<std::size_t>(next - lengths_.begin()) - 1;
  double low = parameters_[piece], high = parameters_[piece + 1];
  const double part = (length - lengths_[piece]) / (lengths_[piece + 1] - lengths_[piece]);
  double u = std::lerp(low, high, part);
  for (int step = 0; step < 100; ++step) {
    const double missing = length - to(u);
    (missing > 0 ? low : high) = u;
    const double wished = u + missing / speed(u);
    const double better = wished > low && wished < high ? wished : 0.5 * (low + high);
    if (std::abs(missing) <= relative_error / 16 * total() || better == u) break;
    u = better;
  }
  return u;
}
//! [arc_length_parameter]

Point ArcLength::at(double part) const {
  const double inside = std::clamp(part, 0.0, 1.0);
  const double u = parameter(inside * total());
  Point point = first_contact::at(curve_, u);
  if (part != inside) point += (part - inside) * total() * first_contact::at(hodograph_, u).normalized();
  return point;
}

}  // namespace first_contact
