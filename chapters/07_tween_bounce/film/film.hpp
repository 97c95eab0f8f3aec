#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "first_contact/figure/scene.hpp"
#include "first_contact/geometry/environment.hpp"
#include "first_contact/motion/play.hpp"
#include "first_contact/motion/rigid_tween.hpp"

/// A film: what an animator writes down, before anything is played.
namespace tween_bounce {

/// A key of a film: where the body is at a time, how it is turned and drawn, and how it goes on from there.
struct FilmKey {
  double time;                     ///< later than that of the key before
  first_contact::Point place;      ///< of the body's middle
  first_contact::Quaternion turn;  ///< of the body
  double scale;  ///< how tall it is drawn; as much narrower as keeps its volume. What collides is rigid.
  first_contact::Easing easing;  ///< of place, turn and scale, to the next key
  first_contact::Path path;      ///< of the place, to the next key
};

/// Something at rest that is in the way.
using Wall = std::variant<first_contact::Plane, first_contact::Box, first_contact::Environment>;

/// What moves: a ball, or a box, each about the origin.
using Actor = std::variant<first_contact::Sphere, first_contact::Box>;

/// What a film says that a contact does.
struct ContactRule {
  std::string what = "stop";   ///< stop, slide or bounce
  first_contact::After after;  ///< the same, for who plays it
};

/// All that a film file says.
struct Film {
  std::string name;                                              ///< that its pictures get
  Actor actor;                                                   ///< what moves
  std::vector<FilmKey> keys;                                     ///< at least two
  std::vector<Wall> walls = {};                                  ///< any number of them
  ContactRule contact = {"stop", first_contact::After::stop()};  ///< with all of them
  first_contact::figure::View view = {};                         ///< from which it is drawn

  /// Its first moment.
  double begin() const { return keys.front().time; }
  /// Its last.
  double end() const { return keys.back().time; }
};

///@{
/// Bounds of what a film may say, so that whatever is read can be played and drawn.
inline constexpr double most_length = 1e6, least_length = 1e-6, most_time = 1e6, most_scale = 8;
inline constexpr std::size_t most_keys = 200, most_points = 100, most_walls = 100, most_frames = 2000;
///@}

}  // namespace tween_bounce
