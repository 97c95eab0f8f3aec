#pragma once
#include <span>
#include <vector>

#include "first_contact/motion/curve.hpp"

/// \file
/// Curves *through* points: where control points only pull, an animator's key positions are to be met. Each leg
/// from one to the next is a cubic Bezier curve, and the legs are joined to one curve.

namespace first_contact {

/// The cubic curve from a to b with the velocities dC/du that it has there (Hermite): the Bezier curve of a,
/// a + velocity_a / 3, b - velocity_b / 3, b.
/// \throws std::invalid_argument as Bezier does.
Bezier hermite(const Point& a, const Vector& velocity_a, const Point& b, const Vector& velocity_b);

/// How far apart the knots of a curve through points are, for a chord of length d. Where points are far apart and
/// then near together, `uniform` swings out and may cross itself; within a leg of a `centripetal` curve there is
/// neither a cusp nor a loop (Yuksel, Schaefer and Keyser, 2011).
enum class Knots {
  uniform,      ///< 1
  centripetal,  ///< root of d
  chordal       ///< d
};

/// The curve of Catmull and Rom (1974) through all points: in each it has the direction of the parabola through it
/// and its two neighbours, with these knots (Barry and Goldman, 1988). At the ends, where a neighbour is missing,
/// its mirror image is taken; so a curve through two points is a line. If the knots are not uniform, it comes to a
/// halt where two points in a row are equal. Moving one point bends two legs on each side.
///
/// Its parameter is that of the knots, from 0 to 1; dC/du has no jumps.
/// \throws std::invalid_argument if there are fewer than two points, one is not finite, or a control point comes
///     out too large (contact.hpp).
BSpline catmull_rom(std::span<const Point> points, Knots knots = Knots::centripetal);

/// Its legs, from each point to the next.
std::vector<Bezier> catmull_rom_legs(std::span<const Point> points, Knots knots = Knots::centripetal);

/// Curves one after the other as one: a B-spline in which as many knots coincide at each joint as its degree,
/// which is that of the highest. Curve i takes the part of [0, 1] that `spans[i]` is of all spans; without spans
/// all take the same.
/// \throws std::invalid_argument if there is no curve, one does not begin exactly where the one before ends, or
///     the spans are not positive and finite, one for each curve.
BSpline joined(std::span<const Bezier> curves, std::span<const double> spans = {});

}  // namespace first_contact
