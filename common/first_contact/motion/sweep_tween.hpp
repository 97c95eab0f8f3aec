#pragma once
#include <concepts>
#include <optional>

#include "first_contact/motion/sweep_along.hpp"
#include "first_contact/motion/tween.hpp"
#include "first_contact/sweep/interval.hpp"

/// \file
/// What is tweened also collides: its path is tested before it is played (paper, 2.4.2 ii).

namespace first_contact {

/// How near to an obstacle counts as touching it for a tween, in units of the scene: of the largest coordinate of
/// the tween's curves and of the obstacle, and the radius. It is four times what `least_gap` allows.
/// \see tests/oracle/sweep_tween.cpp
inline constexpr double tween_gap = 0x1p-30;

/// A linear map of places: where a tween is at p, it is taken to be at `linear` p + `shift`.
struct Bend {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();  ///< the map of displacements
  Vector shift = Vector::Zero();                         ///< where the origin comes to
};

/// First contact of a sphere whose centre is where the tween is, within an interval of time; the interval and the
/// time of the contact are on the tween's own clock.
///
/// Each leg is swept in space, by chords as in `sweep_along`, so that the contact does not depend on any rate of
/// frames; an easing that goes to and fro sweeps its way to and fro. Then the easing, and the length of the curve
/// where the speed is constant, are solved for the time: a straight leg is as exact as the sweep itself. Where an
/// easing jumps, it is swept from the one place to the other, and the time is that of the jump.
///
/// With g = tween_gap times the size of the scene: before the contact the sphere goes nowhere deeper than g into
/// anything that it does not already leave, and at the contact it is at most g away from it. So the time is at most
/// g / v early, if the sphere closes in with speed v, and late by a rounding alone. Nothing deeper than g is missed;
/// what passes at a distance of less than g may be told as a contact.
///
/// \param bend  of the tween's places, which makes none of its ways longer (play.hpp)
/// \throws std::invalid_argument if the radius is no length, or an easing overshoots out of range (contact.hpp).
std::optional<Contact> sweep(const Tween& tween, double radius, const SphereSweep& first_contact_of,
                             double largest_coordinate, const Interval& clock, const Bend& bend = {});

/// The same for whatever `sweep(moving, obstacle)` and `largest_coordinate(obstacle)` are written for, so for what
/// stays where it is.
template <Obstacle Any>
requires requires(const Any& obstacle) {
  { largest_coordinate(obstacle) } -> std::convertible_to<double>;
}
std::optional<Contact> sweep(const Tween& tween, double radius, const Any& obstacle, const Interval& clock) {
  return sweep(
      tween, radius, [&](const Moving<Sphere>& chord) { return sweep(chord, obstacle); },
      largest_coordinate(obstacle), clock);
}

/// From the first key frame to the last.
template <Obstacle Any>
requires requires(const Any& obstacle) {
  { largest_coordinate(obstacle) } -> std::convertible_to<double>;
}
std::optional<Contact> sweep(const Tween& tween, double radius, const Any& obstacle) {
  return sweep(tween, radius, obstacle, Interval(tween.begin(), tween.end()));
}

}  // namespace first_contact
