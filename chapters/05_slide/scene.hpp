#pragma once
#include <string>
#include <vector>

#include "first_contact/geometry/environment.hpp"
#include "first_contact/response/slide.hpp"

/// The scene of the paper's figure 10: a ball on its way from P1 to P2 meets a wall at Q.
struct Scene {
  std::string mesh;  ///< a file; without one, the wall of the figure, which lies level
  first_contact::Point from{-2, -0.5, 2};
  first_contact::Point to{2, 0.5, -0.5};
  double radius = 0.5;

  /// \throws std::invalid_argument if the file is no mesh.
  first_contact::Environment environment() const;
  /// \throws std::invalid_argument if a coordinate of P2 - P1 is not finite.
  first_contact::Moving<first_contact::Sphere> ball() const { return {{from, radius}, to - from}; }
};

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

/// What becomes of a ball that is sent the same way in frame after frame.
struct Frames {
  std::vector<first_contact::Point> positions;  ///< of its centre: at the start, and after each frame
  std::size_t contacts = 0;                     ///< of all frames
};

/// Over the bunny's back, along its cheek and down its chest.
extern const first_contact::Moving<first_contact::Sphere> over_the_bunny;
Frames slide_frames(const first_contact::Moving<first_contact::Sphere>& ball,
                    const first_contact::Environment& environment, int frames);
