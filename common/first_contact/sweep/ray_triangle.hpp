#pragma once
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/contact.hpp"

namespace first_contact {

/// First contact of a moving point, a ray of finite length, with a triangle (paper, 3.2.3): where the ray
/// meets the plane, if that is within the triangle. The triangle has two sides, and the test is watertight: a
/// ray through an edge or a vertex that triangles share meets at least one of them. A ray within the
/// triangle's plane meets its edges and vertices.
///
/// It gives what a sphere of radius 0 gives, and has the same error: t is exact for a point that passes at
/// most 16 eps L beside its path, L being the distance of the point from the corners + the longest side +
/// |V|.
std::optional<Contact> sweep(const Moving<Point>& moving, const Triangle& triangle);

}  // namespace first_contact
