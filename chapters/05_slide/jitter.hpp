#pragma once
#include "rooms.hpp"

/// A ball that is pressed into a corner of two upright walls, 120 degrees from one to the other.
extern const first_contact::Mesh wide_corner;
extern const first_contact::Moving<first_contact::Sphere> into_wide_corner;

/// The slide as one first writes it: at each contact what is left is projected on that wall, and the walls
/// before it are forgotten. Returns where the centre ends.
first_contact::Point wall_after_wall(const first_contact::Moving<first_contact::Sphere>& ball,
                                     const first_contact::Environment& environment);

/// The same, frame after frame.
Frames wall_after_wall_frames(const first_contact::Moving<first_contact::Sphere>& ball,
                              const first_contact::Environment& environment, int frames);
