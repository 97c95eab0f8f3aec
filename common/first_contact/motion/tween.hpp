#pragma once
#include <cstddef>
#include <vector>

#include "first_contact/motion/easing.hpp"
#include "first_contact/motion/path.hpp"

/// \file
/// Tweening (paper, 1.1): the animator gives the key frames, the program what is in between.

namespace first_contact {

/// A place at a time, and how to go on from there to the next key frame. Those of the last key frame are not
/// used.
struct KeyFrame {
  double time;                   ///< later than that of the key frame before
  Point position;                ///< at that time
  Easing easing = ease::linear;  ///< of the way to the next
  Path path = {};                ///< to the next
};

/// A motion through key frames. At each key's time it is exactly at its position; before the first and after
/// the last it stays there.
class Tween {
 public:
  /// \throws std::invalid_argument if there is no key frame, a time is not finite or not later than the one
  ///     before, or a position or control point is not finite.
  explicit Tween(std::vector<KeyFrame> keys);

  /// Where it is at that time.
  Point at(double time) const;
  /// The time of the first key frame.
  double begin() const { return keys_.front().time; }
  /// The time of the last.
  double end() const { return keys_.back().time; }
  /// As they were given.
  const std::vector<KeyFrame>& keys() const { return keys_; }
  /// The way from each key to the next.
  const std::vector<Leg>& legs() const { return legs_; }
  /// The curve from key i to key i + 1.
  const Curve& curve(std::size_t i) const { return legs_[i].curve(); }

 private:
  std::vector<KeyFrame> keys_;
  std::vector<Leg> legs_;
};

/// The same key frames with one smooth way through all of them (catmull_rom): their paths are replaced. How fast
/// it goes on that way still follows from the times and the easings.
/// \throws std::invalid_argument as catmull_rom does.
std::vector<KeyFrame> smooth(std::vector<KeyFrame> keys, Knots knots = Knots::centripetal);

}  // namespace first_contact
