#pragma once
#include <vector>

#include "first_contact/geometry/environment.hpp"
#include "first_contact/response/slide.hpp"

/// Rectangles, two triangles each; each with its middle and two half edges.
struct Rectangle {
  first_contact::Point middle;
  first_contact::Vector u, v;
};
first_contact::Mesh walls(const std::vector<Rectangle>& rectangles);

/// The ground of figure 10; with a second wall; with a third.
extern const std::vector<Rectangle> ground, crease, corner;

/// Two walls and the ball that the report and the figures send into their crease or their corner.
extern const first_contact::Moving<first_contact::Sphere> into_crease, into_corner;

/// The ground, and, unless it is zero, a second wall that rises from it at x = 1 by that vector.
std::vector<Rectangle> ground_with_wall(const first_contact::Vector& wall);

/// What becomes of a ball that is sent the same way in frame after frame.
struct Frames {
  std::vector<first_contact::Point> positions;  ///< of its centre: at the start, and after each frame
  std::size_t contacts = 0;                     ///< of all frames
};

/// Over the bunny's back, along its cheek and down its chest.
extern const first_contact::Moving<first_contact::Sphere> over_the_bunny;
Frames slide_frames(const first_contact::Moving<first_contact::Sphere>& ball,
                    const first_contact::Environment& environment, int frames);
