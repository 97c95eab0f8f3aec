#include "first_contact/motion/tween.hpp"

#include <utility>

#include "first_contact/motion/keys.hpp"

namespace first_contact {

Tween::Tween(std::vector<KeyFrame> keys) : keys_(std::move(keys)) {
  keys::require_in_order(keys_);
  for (std::size_t i = 0; i + 1 < keys_.size(); ++i)
    legs_.emplace_back(keys_[i].path, keys_[i].position, keys_[i + 1].position);
}

//! [tween]
Point Tween::at(double time) const {
  if (!(time > begin())) return keys_.front().position;
  if (time >= end()) return keys_.back().position;
  const std::size_t i = keys::current(keys_, time);
  if (time == keys_[i].time) return keys_[i].position;
  return legs_[i].at(keys::part_of_way(keys_, i, time));
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

}  // namespace first_contact
