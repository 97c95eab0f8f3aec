#pragma once
#include <array>

#include "first_contact/geometry/transform.hpp"

namespace first_contact {

/// What a camera sees: all points on the positive side of six planes that face inwards (paper, 1.3, note 2).
struct Frustum {
  /// The points that the projection maps into the cube [-1, 1]^3, with w > 0 in front of the eye. For a
  /// camera that stands elsewhere: `Transform::perspective(...).after(camera.inverse().transform())`.
  /// \throws std::invalid_argument if one of the six planes is at infinity.
  explicit Frustum(const Transform& projection);

  /// Left, right, bottom, top, near, far.
  std::array<Plane, 6> planes;
};

/// Can nothing of the box be seen? So if its centre is outside the frustum moved out by r_eff: E.Q < -r_eff
/// for one of the planes (paper, 1.3). What is rejected is never in view; what is kept may still be out of
/// view, near an edge or a corner of the frustum, where it is behind no single plane.
bool rejected(const Frustum& frustum, const Box& box);
/// The same for a sphere: E.S < -r for one of the planes.
bool rejected(const Frustum& frustum, const Sphere& sphere);

}  // namespace first_contact
