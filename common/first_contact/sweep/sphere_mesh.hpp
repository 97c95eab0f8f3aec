#pragma once
#include "first_contact/geometry/environment.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Do the sphere and the surface share a point? Touching counts; a sphere that floats inside a closed surface
/// does not overlap it.
bool overlap(const Sphere& sphere, const Mesh& mesh);
/// The same.
bool overlap(const Sphere& sphere, const Environment& environment);

/// First contact of a moving sphere with an arbitrary environment (paper, 2.1): the earliest over all faces,
/// edges and vertices, tested in this order, as the paper does. Flat edges and buried vertices are left out;
/// an edge in a valley (figure 8) is touched by nobody, as one of its faces is nearer. Both sides of the
/// surface are solid.
///
/// The contact's triangle is the touched one, the lowest number if several are touched. The rest of the
/// answer does not depend on the order of the triangles. The error is that of a sphere and a triangle, see
/// sphere_triangle.hpp.
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Environment& environment);

}  // namespace first_contact
