#pragma once
#include <vector>

#include "first_contact/geometry/mesh.hpp"

namespace first_contact::bvh {

/// The tree's own unit of length and origin, chosen so that the mesh lies between -1 and 1.
///
/// The idea: the floats of the tree have tolerances of fixed size, and are right at any scale and offset
/// because the mesh is always brought to the same size and place first. The unit is a power of two, so that a
/// scene scaled by one gives the same tree, bit for bit.
class Space {
 public:
  explicit Space(const Mesh& mesh);

  /// A position in the tree's unit. Its rounding error is at most 2^-52 of its largest coordinate.
  Point point(const Point& p) const { return (p - center_) * scale_; }
  Vector vector(const Vector& v) const { return v * scale_; }
  double length(double l) const { return l * scale_; }

  const Point& center() const { return center_; }
  double scale() const { return scale_; }

 private:
  Point center_ = Point::Zero();
  double scale_ = 1;
};

}  // namespace first_contact::bvh
