#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/space.hpp"
#include "first_contact/motion/timing.hpp"

/// \file
/// What key frames and key poses have in common: each has a time, a position and an easing.

namespace first_contact::keys {

/// \throws std::invalid_argument if there is none, a time or a position is not finite, or a time not later than the
///     one before.
template <class Key>
void require_in_order(const std::vector<Key>& keys) {
  if (keys.empty()) refuse("tween", "must have a key frame");
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string what = "tween's key frame " + std::to_string(i) + ", time " + to_text(keys[i].time);
    if (!std::isfinite(keys[i].time)) refuse(what, "must be finite");
    if (i > 0 && !(keys[i].time > keys[i - 1].time)) refuse(what, "must be later than the one before");
    require_finite(keys[i].position, what + ", position");
  }
}

/// The number of the last key whose time has come; of the first, before that.
template <class Key>
std::size_t current(const std::vector<Key>& keys, double time) {
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), time, [](double t, const Key& key) { return t < key.time; });
  return static_cast<std::size_t>(std::max(next - keys.begin(), std::ptrdiff_t{1})) - 1;
}

/// The part of the way from key i to the next that is done at a time between the two.
template <class Key>
double part_of_way(const std::vector<Key>& keys, std::size_t i, double time) {
  return Timing(keys[i].easing, keys[i].time, keys[i + 1].time).part_at(time);
}

}  // namespace first_contact::keys
