#pragma once
// How space is seen in a picture: along parallel rays, by an eye that is turned about the upright axis, and lifted.
#include "first_contact/geometry/mesh.hpp"

namespace touch {

using first_contact::Mesh, first_contact::Point, first_contact::Vector;

struct View {
  /// \param turn,tilt  in degrees: from the x axis, and above the ground
  View(double turn, double tilt, const Point& middle);

  /// What is seen at (x, y) of the picture, so far before the plane through its middle.
  Point point(double x, double y, double depth) const { return middle + x * right + y * up + depth * eye; }
  /// For the drawing.
  void tell() const;

  Point middle;
  Vector eye, right, up;  // unit vectors
};

/// The middle of its bounds.
Point middle_of(const Mesh& mesh);
/// Each coordinate in whole thousandths: so many digits are enough for who reads them.
Point in_thousandths(const Point& point);
/// Its vertices and faces, for the drawing.
void tell_mesh(const Mesh& mesh);

}  // namespace touch
