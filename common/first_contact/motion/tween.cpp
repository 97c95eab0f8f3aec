#include "first_contact/motion/tween.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/motion/timing.hpp"

namespace first_contact {

namespace {

template <class Key>
void require_keys(const std::vector<Key>& keys) {
  if (keys.empty()) refuse("tween", "must have a key frame");
  for (std::size_t i = 0; i < keys.size(); ++i) {
    std::ostringstream what;
    what << "tween's key frame " << i << ", time " << keys[i].time;
    if (!std::isfinite(keys[i].time)) refuse(what.str(), "must be finite");
    if (i > 0 && !(keys[i].time > keys[i - 1].time)) refuse(what.str(), "must be later than the one before");
    require_finite(keys[i].position, what.str() + ", position");
  }
}

// The last key whose time has come; none before the first.
template <class Key>
std::size_t current(const std::vector<Key>& keys, double time) {
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), time, [](double t, const Key& key) { return t < key.time; });
  return static_cast<std::size_t>(std::max(next - keys.begin(), std::ptrdiff_t{1})) - 1;
}

template <class Key>
double part_of_way(const std::vector<Key>& keys, std::size_t i, double time) {
  return Timing(keys[i].easing, keys[i].time, keys[i + 1].time).part_at(time);
}

}  // namespace

Tween::Tween(std::vector<KeyFrame> keys) : keys_(std::move(keys)) {
  require_keys(keys_);
  for (std::size_t i = 0; i + 1 < keys_.size(); ++i)
    legs_.emplace_back(keys_[i].path, keys_[i].position, keys_[i + 1].position);
}

//! [tween]
Point Tween::at(double time) const {
  if (!(time > begin())) return keys_.front().position;
  if (time >= end()) return keys_.back().position;
  const std::size_t i = current(keys_, time);
  if (time == keys_[i].time) return keys_[i].position;
  return legs_[i].at(part_of_way(keys_, i, time));
}
//! [tween]

std::vector<KeyFrame> smooth(std::vector<KeyFrame> keys, Knots knots) {
  std::vector<Point> points;
  for (const KeyFrame& key : keys) points.push_back(key.position);
  const std::vector<Bezier> legs = catmull_rom_legs(points, knots);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const std::vector<Point>& control = legs[i].control_points();
    keys[i].path = Path::bezier({control[1], control[2]}, keys[i].path.constant_speed);
  }
  return keys;
}

RigidTween::RigidTween(std::vector<Pose> poses) : poses_(std::move(poses)) {
  require_keys(poses_);
  for (Pose& pose : poses_) {
    const double length = norm(pose.orientation);
    if (!(length > 0) || !std::isfinite(length)) refuse("tween's orientation", "must be finite and not zero");
    pose.orientation.coeffs() /= length;
  }
}

namespace {

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

}  // namespace

//! [rigid_tween]
Rigid RigidTween::at(double time) const {
  const std::size_t i = current(poses_, time);
  const Pose& from = poses_[i];
  if (!(time > from.time) || i + 1 == poses_.size()) return {from.orientation, from.position};
  const Pose& to = poses_[i + 1];
  const double part = part_of_way(poses_, i, time);
  return {turned_part_of_way(from.orientation, to.orientation, part),
          (1 - part) * from.position + part * to.position};
}
//! [rigid_tween]

}  // namespace first_contact
