#pragma once
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// First contact of a moving point, a ray of finite length, with a triangle (paper, 3.2.3): where the ray
/// meets the plane, if that is within the triangle (line_triangle.hpp). The test is watertight: a ray through
/// an edge or a vertex that triangles share meets at least one of them. The triangle has two sides.
///
/// A ray is the path of a sphere of radius 0, and is swept as one: the face is moved out by nothing, and the
/// cylinders and spheres are the edges and the vertices themselves, for the rays that run within the
/// triangle's plane.
///
/// Error: let L be the distance of the point from the corners + the longest side + |V|. At the time of
/// contact the point is within 16 eps L of the triangle, be the angle as flat and the triangle as thin as may
/// be; and a path that passes inside all sides, from before the plane to behind it, all by more than that, is
/// never missed. The time itself is wrong by at most 16 eps L / |N.V|.
std::optional<Contact> sweep(const Moving<Point>& moving, const Triangle& triangle);

}  // namespace first_contact
