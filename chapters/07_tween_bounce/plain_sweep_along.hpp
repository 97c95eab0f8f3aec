#pragma once
#include <optional>

#include "first_contact/geometry/plane.hpp"
#include "first_contact/motion/curve.hpp"

/// A ball on a curve against a plane, as one writes it first: some chords in the place of the curve.

namespace tween_bounce {

/// At which parameter, from 0 to 1, the ball on the chords first touches the plane; nothing if it does not.
/// The ball on the curve may touch it earlier, later, or though the other does not.
std::optional<double> plain_sweep_along(const first_contact::Curve& curve, double radius,
                                        const first_contact::Plane& plane, int chords);

}  // namespace tween_bounce
