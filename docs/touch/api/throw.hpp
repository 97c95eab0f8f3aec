#pragma once
// A ball thrown at the rabbit. A ray through the pointer picks where it is sent (paper, 3.2.3 and 3.2.4), and the fast tree
// finds what it meets.
#include <optional>

#include "first_contact/bvh/bvh.hpp"
#include "view.hpp"

namespace touch {

using first_contact::Bvh, first_contact::Contact, first_contact::Moving, first_contact::Sphere;

/// chapters/meshes/bunny.off, as it is read by a program.
const Bvh& bunny();

/// Places in the picture, where the ball is in the hand and where it is sent.
struct Throw {
  double hand_x, hand_y, aim_x, aim_y, radius;

  /// Tells what is picked, and both ends of the way.
  Moving<Sphere> ball(const View& view) const;
};

/// What it meets is told, as by the program, and answered.
std::optional<Contact> tell_contact(const Moving<Sphere>& ball);

}  // namespace touch
