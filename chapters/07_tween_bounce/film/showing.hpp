#pragma once
#include <optional>
#include <string>
#include <vector>

#include "film.hpp"

namespace tween_bounce {

/// A picture of a film: where the body is, how it is turned and how tall it is drawn.
struct Frame {
  double time;
  first_contact::Point place;
  Eigen::Quaterniond turn;  ///< of length 1
  double scale;
};

/// A film as it is shown: its paths are tested first, against all that is in the way; then it can be asked for any
/// moment. What is met, and when, does not depend on how many pictures are asked for.
class Showing {
 public:
  /// Tests the paths.
  explicit Showing(const Film& film);

  /// The body at a time of the film.
  Frame at(double time) const;
  /// The places of the plan, that knows of nothing in the way.
  first_contact::Point planned(double time) const { return poses_.at(time).translation(); }
  /// The contacts in order, on the film's clock.
  const std::vector<first_contact::Contact>& contacts() const { return contacts_; }

 private:
  first_contact::RigidTween poses_;
  std::vector<FilmKey> keys_;
  std::optional<first_contact::Played> ball_;
  std::vector<first_contact::Contact> contacts_;
  std::optional<double> stopped_;  // from when on nothing changes any more
};

/// The first contact with all that is in the way: of equal ones, with what the film names first.
std::optional<first_contact::Contact> first_of_all(
    const std::vector<Wall>& walls, const first_contact::Moving<first_contact::Sphere>& moving);

/// The places of a film's keys, as a tween.
first_contact::Tween places_of(const Film& film);

/// The times of the pictures from `begin` to `end`: so many a second, and the last one at the end.
/// \throws std::invalid_argument if they are more than `most_frames`.
std::vector<double> picture_times(double begin, double end, double per_second);

/// The pictures as a table, with the columns time,x,y,z,qw,qx,qy,qz,scale.
std::string csv(const Showing& showing, const std::vector<double>& times);

}  // namespace tween_bounce
