#pragma once
#include "first_contact/motion/easing.hpp"

/// \file
/// Easings with parameters. Each is an `in`, slow at first; `out` and `in_out` make the others of it, also of an
/// easing of one's own.
///
/// Penner's published formulas ("Programming Macromedia Flash MX", ch. 7, and his code of 2001) are these, but for
/// what each says below, and for two that hold for all: a published formula that is not 0 at the start (exponential,
/// elastic: 2^-10) jumps there, these are; and *in-out* is always the `in`, half as large, and its mirror image,
/// while the published in-out of back has 1.525 times the overshoot, and that of elastic 1.5 times the period:
/// `in_out(back(1.525 * 1.70158))` and `in_out(elastic(1, 0.45))` are those.
///
/// Where an easing goes through a power, an exponential or a sine, it depends on the C library in its last bits.

namespace first_contact::ease {

/// Slow at the end: the mirror image of an easing, 1 - f(1 - t).
Easing out(const Easing& in);
/// Slow at both ends: the easing, half as large, and then its mirror image.
Easing in_out(const Easing& in);

/// t^n: 2 is quadratic, 5 quintic.
/// \throws std::invalid_argument if the exponent is not positive and finite.
Easing power(double exponent);
/// (2^bt - 1) / (2^b - 1): Penner's is 2^(b (t - 1)), with b = 10, which does not begin at 0. As b gets small it is
/// linear; b < 0 is an `out`.
/// \throws std::invalid_argument if b is 0, or its size larger than 1000.
Easing exponential(double b);
/// t^2 ((s + 1) t - s): it goes back first. With s = 1.70158 by a tenth of the way; by 4 s^3 / (27 (s + 1)^2) in
/// general.
/// \throws std::invalid_argument if the overshoot s is negative or not finite.
Easing back(double overshoot = 1.70158);
/// A spring that swings up: a (2^10t - 1) / 1023 cos(2 pi (1 - t) / p - acos(1 / a)). Penner's has 2^(10 (t - 1)) for
/// the fraction; where he takes an amplitude below 1 for 1, it is refused, as it cannot end at 1.
/// \param amplitude  a, of the last swing, at least 1
/// \param period  p, of a swing, in units of the tween's time, at least 1/64
/// \throws std::invalid_argument that names the value and the rule.
Easing elastic(double amplitude = 1, double period = 0.3);

/// A weight on a spring, let go at rest, that comes to its goal: x'' = w^2 (1 - x) - 2 z w x', with w = 2 pi cycles.
/// Its way is divided by where it is at t = 1, so that the tween ends at its goal; that is off by e^(-z w) or so.
/// It is right to 64 eps, and 16 more for each cycle, of itself or of 1, whichever is more.
/// \param cycles  that the spring without damping makes in the tween's time, from 0.001 to 64
/// \param damping  z, from 0.01 to 100: below 1 it swings beyond its goal, at 1 it comes there fastest without that
/// \throws std::invalid_argument if one of them is out of its range.
/// \see tests/oracle/left_out.cpp
Easing spring(double cycles, double damping);

}  // namespace first_contact::ease
