#pragma once
#include <array>

#include "first_contact/geometry/box.hpp"

namespace first_contact {

/// The three pairs of faces of a box, with its centre for the origin: a point lies in the box if its height
/// over the middle of each pair is at most half the way between them.
struct BoxFrame {
  /// Of any box; what is flat has faces all the same, with nothing between them.
  explicit BoxFrame(const Box& box);

  /// Over the middle of each pair, of a point given from the box's centre.
  Vector heights(const Point& point) const;
  /// Is the point, given from the box's centre, in the box?
  bool holds(const Point& point) const;

  std::array<Vector, 3> normals;  ///< unit; of the faces at the ends of R, S, T
  Vector half;                    ///< half the way from one face of a pair to the other
};

}  // namespace first_contact
