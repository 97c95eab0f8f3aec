#include "first_contact/motion/squash.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

namespace {

constexpr double least_stretch = 0x1p-100, most_stretch = 0x1p100;

void require_stretch(double stretch) {
  if (!(stretch >= least_stretch && stretch <= most_stretch))
    refuse("stretch", stretch, "must be in 2^-100 .. 2^100");
}
double nearest_stretch(double any) { return std::clamp(any, least_stretch, most_stretch); }

}  // namespace

//! [squash]
Eigen::Matrix3d squash(const Vector& axis, double stretch) {
  require_finite(axis, "axis");
  if (axis.isZero(0)) refuse("axis 0, 0, 0", "must not be zero");
  require_stretch(stretch);
  const Vector n = normalized(axis);
  const double wide = 1 / std::sqrt(stretch);
  const Eigen::Matrix3d along = n * n.transpose();
  return wide * (Eigen::Matrix3d::Identity() - along) + stretch * along;
}

double eased_stretch(double a, double b, const Easing& easing, double part) {
  require_stretch(a);
  require_stretch(b);
  return nearest_stretch(a * std::pow(b / a, easing(part)));
}
//! [squash]

}  // namespace first_contact
