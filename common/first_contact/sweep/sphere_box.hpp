#pragma once
#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Do the sphere and the box share a point? The box is solid. Touching counts.
bool overlap(const Sphere& sphere, const Box& box);
/// The same.
inline bool overlap(const Box& box, const Sphere& sphere) { return overlap(sphere, box); }

/// First contact of a moving sphere with a box, which is solid: its centre meets the box moved out by r, that
/// is a face, a cylinder about an edge or a ball about a vertex (paper, 2.1), whichever is first.
///
/// A centre within the box is judged by the nearest face: it goes deeper if it moves away from that, and
/// where several are equally near, from each of them. In the middle between two opposite faces, as on a box
/// without thickness, the normal is against the motion.
///
/// The feature is what of the box is touched. Error: that of a sphere and a triangle, see
/// sphere_triangle.hpp, with the longest diagonal in the place of the longest side.
/// \see tests/oracle/sphere_box.cpp
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Box& box);

/// First contact of a moving box with a sphere at rest: the sphere comes to the box, and the answer is told
/// from the other side. The feature is what of the box touches.
std::optional<Contact> sweep(const Moving<Box>& moving, const Sphere& sphere);

}  // namespace first_contact
