#pragma once
#include "first_contact/geometry/space.hpp"
#include "first_contact/motion/easing.hpp"

/// \file
/// Squash and stretch (Lasseter, 1987): an animator's answer to what rigid bodies leave out. What is pressed flat
/// becomes wider, so that its volume stays what it was.

namespace first_contact {

/// The map that makes a body `stretch` times as long along an axis, and 1 / root of that as wide: its determinant is
/// 1, to within 8 eps times the ratio of its longest side to its shortest. Below 1 it is a squash.
/// \param axis  of any length but zero
/// \throws std::invalid_argument if the axis is zero or not finite, or the stretch not in 2^-100 .. 2^100.
Eigen::Matrix3d squash(const Vector& axis, double stretch);

/// A stretch that is eased: from a^(1 - f) b^f with f the easing at that part of the time, so that it halves as it
/// doubles. However far an easing overshoots, it stays in 2^-100 .. 2^100, where `squash` takes it.
/// \throws std::invalid_argument if a or b is not in 2^-100 .. 2^100.
double eased_stretch(double a, double b, const Easing& easing, double part);

}  // namespace first_contact
