#pragma once
#include "first_contact/geometry/transform.hpp"

/// A turn between two orientations, as one writes it first: right while they differ, and by less than
/// half a turn.

namespace tween_bounce {

/// The part s of the way from a to b, both of length 1.
first_contact::Quaternion plain_slerp(const first_contact::Quaternion& a, const first_contact::Quaternion& b,
                                      double s);

/// Of so many bodies that do not turn between two keys, each in an orientation of its own, those whose
/// orientation half way between is not a number.
int lost_at_rest(int bodies);

}  // namespace tween_bounce
