#pragma once
#include <array>
#include <optional>
#include <vector>

#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/contact.hpp"

/// A wedge whose sharp edge is the y axis, open downwards: two faces that slope away from it at `half_angle`
/// to the vertical.
struct Wedge {
  double half_angle;  ///< in radians

  /// The planes of its faces; the normals point outwards.
  std::array<first_contact::Plane, 2> planes() const;
  /// Its faces as triangles, long enough for what comes near the edge.
  std::vector<first_contact::Triangle> faces() const;
};

//! [grown]
/// When a ball enters the wedge as a BSP tree of planes grown by r sees it: its centre is behind all planes
/// that are moved out by r. Nothing if it never is. This is not a contact: the corner of the grown planes
/// sticks out to r / sin(half angle).
std::optional<double> time_at_grown_planes(const first_contact::Moving<first_contact::Sphere>& ball,
                                           const Wedge& wedge);
//! [grown]
