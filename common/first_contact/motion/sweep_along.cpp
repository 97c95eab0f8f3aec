#include "first_contact/motion/sweep_along.hpp"

#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

constexpr double most_chords = 1e7;

}  // namespace

//! [chords]
std::vector<double> chords(const Curve& curve, double deviation) {
  if (!(deviation > 0) || !std::isfinite(deviation))
    refuse("sweep's deviation", deviation, "must be finite and greater than zero");
  const double unit = unit_scale(largest_coordinate(curve));  // C'' is longer than that, by the degree
  const double bend = longest_control_vector(derivative(derivative(scaled(curve, unit))));
  const std::vector<double> joints = breaks(curve);
  std::vector<double> u{0};
  for (std::size_t i = 1; i < joints.size(); ++i) {
    const double span = joints[i] - joints[i - 1];
    const double needed = std::max(1.0, std::ceil(span * std::sqrt(bend / (unit * deviation) / 8)));
    if (!(static_cast<double>(u.size()) + needed <= most_chords))
      refuse("sweep's deviation", deviation, "too small for this curve");
    const auto count = static_cast<std::size_t>(needed);
    for (std::size_t k = 1; k < count; ++k)
      u.push_back(joints[i - 1] + span * static_cast<double>(k) / static_cast<double>(count));
    u.push_back(joints[i]);
  }
  return u;
}
//! [chords]

}  // namespace first_contact
