#pragma once
#include <concepts>
#include <optional>

#include "first_contact/geometry/largest_coordinate.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/motion/chords.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// How near to an obstacle counts as touching it along a curve, at the least, in units of the scene: of the largest
/// coordinate of the curve and of the obstacle, and the radius. Along a chord next to something a sphere may sink
/// by `slide_gap`, which is not told from sliding; of a cubic that glides along it all the way there are some
/// sqrt(6 / (4 g)) chords for a gap g, and 2^-32 is the least power of two for which what they add up to is below
/// half of the gap.
/// \see tests/unit/sweep_along.cpp
inline constexpr double least_gap = 0x1p-32;

/// A sphere that goes along curves, past what stays where it is.
class CurveSweep {
 public:
  /// \param gap  in the unit of the scene
  /// \param largest_coordinate  of the obstacles and of all that will be asked about
  /// \throws std::invalid_argument if the radius is no length, or the gap is not finite or less than `least_gap`
  ///     of the scene.
  CurveSweep(double radius, SphereSweep first_contact_of, double gap, double largest_coordinate);

  /// The first contact along a Bezier curve. Its time is the parameter, which goes from `begin` to `end`.
  std::optional<Contact> along(const Bezier& curve, double begin, double end) const;

 private:
  Glance look_along(const Chord& chord) const;
  std::optional<Contact> along_straight(const Moving<Sphere>& chord) const;
  bool is_near(const Sphere& sphere) const;

  double radius_;
  SphereSweep first_contact_of_;
  double allowed_, rounding_;
};

/// First contact of a sphere whose centre moves along a curve, at C(u), with obstacles that stay where they are.
/// The time of the contact is u, in [0, 1].
///
/// On a chord that is within d of the curve, a sphere with a radius larger by d holds the true one, at every u: if
/// it meets nothing, nothing is met. If it does, the chord is halved, until d <= gap / 2. So the contract is that
/// of every sweep (contact.hpp), with the gap as its bound: before the contact the sphere goes nowhere deeper than
/// the gap into anything that it does not already leave, and at the contact it is no farther away than the gap.
/// Where it goes along at a distance within the gap it is in contact as soon as it comes nearer.
///
/// \param gap  in the unit of the scene. A smaller one costs no more but where the sphere glides along something.
/// \throws std::invalid_argument as CurveSweep does.
std::optional<Contact> sweep_along(const Curve& curve, double radius, const SphereSweep& first_contact_of,
                                   double largest_coordinate, double gap);

/// The same for whatever `sweep(moving, obstacle)` and `largest_coordinate(obstacle)` are written for.
template <Obstacle Any>
requires requires(const Any& obstacle) {
  { largest_coordinate(obstacle) } -> std::convertible_to<double>;
}
std::optional<Contact> sweep_along(const Curve& curve, double radius, const Any& obstacle, double gap) {
  return sweep_along(
      curve, radius, [&](const Moving<Sphere>& chord) { return sweep(chord, obstacle); },
      largest_coordinate(obstacle), gap);
}

}  // namespace first_contact
