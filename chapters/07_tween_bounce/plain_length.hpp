#pragma once
#include "first_contact/motion/curve.hpp"

/// The length of a curve, as one writes it first: always a little short.

namespace tween_bounce {

/// The sum of so many chords, evenly spaced by the parameter.
double plain_length(const first_contact::Curve& curve, int chords);

}  // namespace tween_bounce
