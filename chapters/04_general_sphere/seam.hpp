#pragma once

/// Balls aimed at the seam of two triangles that lie in one plane: does rounding let any of them through?

namespace general_sphere_chapter {

/// Of how many balls.
struct SeamShots {
  int balls;
  int both_faces_missed;  ///< if each triangle is asked for its face alone
  int missed;             ///< if each is asked for all that it has
};
/// A hundred thousand balls of that radius, each at a seam of its own, about as long as the ball comes from.
SeamShots shots_at_a_seam(double radius);

}  // namespace general_sphere_chapter
