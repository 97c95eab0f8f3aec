#pragma once
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/environment.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Do the box and the triangle share a point? The box is solid. Touching counts, up to rounding.
bool overlap(const Box& box, const Triangle& triangle);
/// Do the box and the surface share a point? A box that floats inside a closed surface does not overlap it.
bool overlap(const Box& box, const Mesh& mesh);
/// The same.
inline bool overlap(const Box& box, const Environment& environment) {
  return overlap(box, environment.mesh());
}

/// First contact of a moving box with a triangle, which has two sides, by separating axes as in box_box.hpp,
/// with the same error. The feature is what of the triangle is touched.
std::optional<Contact> sweep(const Moving<Box>& moving, const Triangle& triangle);

/// First contact of a moving box with a surface: the earliest over all triangles; of equal t the face before
/// the edge before the vertex, then the lowest number. Each triangle is judged for itself: a box that slides
/// along a floor of many triangles and touches it exactly meets none of them, but one that is sunk in by a
/// rounding may meet the side of the next.
std::optional<Contact> sweep(const Moving<Box>& moving, const Environment& environment);

}  // namespace first_contact
