#include "first_contact/motion/rigid_tween.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/motion/keys.hpp"

namespace first_contact {

namespace {

// Of the four numbers of a rotation the largest is found first, so that no digits are lost (Shepperd, 1978).
Quaternion quaternion_of(const Eigen::Matrix3d& m) {
  const double x = m(0, 0), y = m(1, 1), z = m(2, 2);
  const double a = m(2, 1) - m(1, 2), b = m(0, 2) - m(2, 0), c = m(1, 0) - m(0, 1);
  const double d = m(1, 0) + m(0, 1), e = m(0, 2) + m(2, 0), f = m(2, 1) + m(1, 2);
  if (x + y + z >= std::max({x, y, z})) return {1 + x + y + z, a, b, c};
  if (x >= std::max(y, z)) return {a, 1 + x - y - z, d, e};
  if (y >= z) return {b, d, 1 + y - x - z, f};
  return {c, e, f, 1 + z - x - y};
}

void require_rigid(const Matrix& matrix) {
  const Eigen::Matrix3d m = matrix.topLeftCorner<3, 3>();
  const Eigen::Matrix3d off = product(m.transpose(), m) - Eigen::Matrix3d::Identity();
  if (const Homogeneous last = matrix.row(3); last != Homogeneous(0, 0, 0, 1))
    refuse("pose's last row " + to_text(Vector(last.head<3>())) + ", " + to_text(last.w()),
           "must be 0, 0, 0, 1");
  if (!(off.cwiseAbs().maxCoeff() <= rotation_tolerance))
    refuse("pose's matrix", "must not stretch or shear");
  if (!(dot(Vector(m.col(0).cross(m.col(1))), m.col(2)) > 0)) refuse("pose's matrix", "must not mirror");
}

}  // namespace

Pose pose(double time, const Matrix& matrix, const Easing& easing, const Path& path) {
  require_rigid(matrix);
  return {time, matrix.topRightCorner<3, 1>(), quaternion_of(matrix.topLeftCorner<3, 3>()), easing, path};
}

RigidTween::RigidTween(std::vector<Pose> poses) : poses_(std::move(poses)) {
  keys::require_in_order(poses_);
  for (Pose& pose : poses_) {
    const auto& numbers = pose.orientation.coeffs();
    if (!numbers.allFinite() || numbers.isZero(0))
      refuse("tween's orientation of length", norm(pose.orientation), "must be finite and not zero");
    pose.orientation = normalized(pose.orientation);
  }
  for (std::size_t i = 0; i + 1 < poses_.size(); ++i)
    legs_.emplace_back(poses_[i].path, poses_[i].position, poses_[i + 1].position);
}

namespace {

//! [slerp]
// The shorter way from a to b at constant speed, both of length 1 (Shoemake 1985). Where they are so near to
// each other that the angle has no digits left, it is straight.
Quaternion turned_part_of_way(const Quaternion& a, const Quaternion& b, double part) {
  const Homogeneous from = a.coeffs(), to = b.coeffs();
  const double cosine = dot(from, to), shorter = cosine < 0 ? -1 : 1;
  const double angle = std::acos(std::min(std::abs(cosine), 1.0));
  if (!(std::abs(cosine) < 1 - std::numeric_limits<double>::epsilon()))
    return Quaternion(Homogeneous((1 - part) * from + shorter * part * to));
  const double of_from = std::sin((1 - part) * angle) / std::sin(angle);
  const double of_to = shorter * std::sin(part * angle) / std::sin(angle);
  return Quaternion(Homogeneous(of_from * from + of_to * to));
}
//! [slerp]

}  // namespace

//! [rigid_tween]
Rigid RigidTween::at(double time) const {
  const std::size_t i = keys::current(poses_, time);
  const Pose& from = poses_[i];
  if (!(time > from.time) || i + 1 == poses_.size()) return {from.orientation, from.position};
  const double part = keys::part_of_way(poses_, i, time);
  return {turned_part_of_way(from.orientation, poses_[i + 1].orientation, part), legs_[i].at(part)};
}
//! [rigid_tween]

// What turns the one into the other, b a^-1, by the shorter way: its vector is the axis times the sine of half the
// angle.
Turn RigidTween::turn(std::size_t i) const {
  const Quaternion &a = poses_[i].orientation, &b = poses_[i + 1].orientation;
  const Vector u(a.x(), a.y(), a.z()), v(b.x(), b.y(), b.z());
  const Vector vector = a.w() * v - b.w() * u - v.cross(u);
  const double cosine = dot(a.coeffs(), b.coeffs()), sine = norm(vector);
  if (sine == 0) return {Vector(0, 0, 1), 0};
  return {normalized(cosine < 0 ? Vector(-vector) : vector), 2 * std::atan2(sine, std::abs(cosine))};
}

}  // namespace first_contact
