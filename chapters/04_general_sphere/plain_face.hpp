#pragma once
#include <optional>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/moving.hpp"

/// A ball and the face of a triangle, as one writes it first: right for ordinary triangles and balls that come
/// from the side of the normal.

namespace general_sphere_chapter {

/// When the ball touches the face; nothing if it does not.
std::optional<double> plain_face(const first_contact::Moving<first_contact::Sphere>& ball,
                                 const first_contact::Triangle& triangle);

}  // namespace general_sphere_chapter
