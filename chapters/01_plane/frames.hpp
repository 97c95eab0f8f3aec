#pragma once
#include <optional>

#include "first_contact/sweep/sphere_plane.hpp"

/// What one knows of a motion who looks at the frames of a film alone, and asks in each whether two things
/// overlap.

//! [frames]
/// The sphere in frame i of n, which is at the time i / n; frame 0 is the start.
inline first_contact::Sphere in_frame(long i, long n,
                                      const first_contact::Moving<first_contact::Sphere>& ball) {
  return {ball.shape.center + (double(i) / double(n)) * ball.displacement, ball.shape.radius};
}

/// The first of the frames 0 to n in which the sphere overlaps the plane. Between two frames nobody looks.
inline std::optional<long> first_frame_of_overlap(long n,
                                                  const first_contact::Moving<first_contact::Sphere>& ball,
                                                  const first_contact::Plane& plane) {
  for (long i = 0; i <= n; ++i)
    if (overlap(in_frame(i, n, ball), plane)) return i;
  return {};
}
//! [frames]
