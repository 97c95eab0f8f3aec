#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "first_contact/motion/curve.hpp"
#include "first_contact/sweep/contact.hpp"

/// \file
/// Between two pictures motion is taken as straight, even along a curve (paper, 1.1). Here it is said how straight,
/// and where it need not be.

namespace first_contact {

/// The values of u in [0, 1] between which chords stay within `deviation` of the curve, at every u: a chord
/// over a step h of u is off by at most h^2 / 8 max |C''|, and C'' is no longer than its own control vectors.
/// \throws std::invalid_argument if the deviation is not finite and positive, or would need more than 10
///     million chords.
std::vector<double> chords(const Curve& curve, double deviation);

/// By how much the chord from a Bezier curve's beginning to its end is off, at any u: the same bound.
double deviation_of_chord(const Bezier& curve);

/// A chord of a curve.
struct Chord {
  ///@{
  /// Of the curve, at `begin` and at `end`.
  Point from, to;
  ///@}
  ///@{
  /// The parameter of the curve there; between them it grows, or shrinks, evenly along the chord.
  double begin, end;
  ///@}
  double deviation;      ///< the curve is at most this far off it, at every parameter
  bool straight_enough;  ///< it is not halved any more
};

/// What is seen along a chord.
struct Glance {
  std::optional<Contact> contact;  ///< the first one, with its time on the chord, in [0, 1]
  bool clear;  ///< is it known that the curve, as near to the chord as it is, meets nothing?
};

/// The first contact along a curve: a chord is looked along, and halved where it is not clear, until it is within
/// `allowed` of the curve. So chords are short where it matters alone. Its contact's time is the parameter,
/// between `begin` at the curve's beginning and `end` at its end.
///
/// After 26 halvings the deviation, which each makes four times smaller, is its own rounding; that is the last one.
std::optional<Contact> first_along(const Bezier& curve, double begin, double end, double allowed,
                                   const std::function<Glance(const Chord&)>& look);

}  // namespace first_contact
