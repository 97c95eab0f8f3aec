#pragma once
#include <vector>

#include "film/showing.hpp"
#include "first_contact/figure/palette.hpp"

namespace tween_bounce {

/// A face of a body in space; without corners if the eye does not see it.
struct Face {
  std::vector<first_contact::Point> corners;
  const first_contact::figure::Colour& colour;
};

/// What one sees of a body: always as many faces and lines, each with as many corners.
struct Shape {
  std::vector<Face> faces;
  std::vector<std::vector<first_contact::Point>> lines;  ///< upon them, by which one sees it turn
};

/// A body as it is drawn, squashed or stretched about its lowest point.
Shape shape_of(const Actor& actor, const Frame& frame, const first_contact::figure::View& view);

/// How far a body reaches from its middle.
double reach_of(const Actor& actor);

/// The piece of a plane that is drawn: as large as the room, and not beyond the other planes, on the side of a point.
std::vector<first_contact::Point> piece_of(const first_contact::Plane& plane, const Eigen::AlignedBox3d& room,
                                           const std::vector<Wall>& walls, const first_contact::Point& side);

}  // namespace tween_bounce
