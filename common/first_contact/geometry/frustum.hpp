#pragma once
#include <array>
#include <limits>

#include "first_contact/geometry/transform.hpp"

namespace first_contact {

/// What a camera sees: all points on the positive side of six planes that face inwards (paper, 1.3, note 2).
struct Frustum {
  /// The points that the projection maps into the cube [-1, 1]^3, with w > 0 in front of the eye. For a
  /// camera that stands elsewhere: `Transform::perspective(...).after(camera.inverse().transform())`.
  ///
  /// Each plane is right to a few eps of the distances in it, be the far plane as far as it may. (Of another
  /// projection, one given by its matrix alone, the far plane is what the matrix still says of it.)
  /// \throws std::invalid_argument if one of the six planes is at infinity.
  explicit Frustum(const Transform& projection);

  /// Left, right, bottom, top, near, far.
  std::array<Plane, 6> planes;
};

/// A shape is rejected if it is behind a plane by more than this part of |Q| + |D| + its radius: two eps of
/// the plane's normal, as many of a product, one of a sum, one of the length of the normal and two of D, and
/// as much again for the camera's turn; the next power of two. So what touches the frustum is not rejected
/// for rounding. (A camera that stands far from the origin moves its planes by an eps or so of that
/// distance.)
/// \see tests/property/frustum.cpp
inline constexpr double rounding_of_rejection = 32 * std::numeric_limits<double>::epsilon();

/// Can nothing of the box be seen? So if its centre is outside the frustum moved out by r_eff: E.Q < -r_eff
/// for one of the planes (paper, 1.3). What is rejected is never in view; what is kept may still be out of
/// view, near an edge or a corner of the frustum, where it is behind no single plane.
bool rejected(const Frustum& frustum, const Box& box);
/// The same for a sphere: E.S < -r for one of the planes.
bool rejected(const Frustum& frustum, const Sphere& sphere);

}  // namespace first_contact
