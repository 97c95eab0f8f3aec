#pragma once
#include <vector>

#include "first_contact/motion/tween.hpp"
#include "first_contact/sweep/obstacle.hpp"

/// A tween played past what is in its way, as one writes it first: picture by picture.

namespace tween_bounce {

/// Where the ball is in each picture.
std::vector<first_contact::Point> plain_play(const first_contact::Tween& plan, double radius,
                                             const first_contact::SphereSweep& first_contact_of, double e,
                                             double pictures_a_second);

}  // namespace tween_bounce
