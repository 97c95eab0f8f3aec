#pragma once
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/obstacle.hpp"

namespace first_contact {

/// Do the sphere and the triangle share a point? Touching counts. The triangle may be degenerate.
bool overlap(const Sphere& sphere, const Triangle& triangle);

/// First contact of a moving sphere with a triangle (paper, 2.1): its centre meets the face moved out by r,
/// or a cylinder of radius r about an edge, or a sphere of radius r about a vertex, whichever is first. The
/// triangle has two sides; a degenerate one acts as the segment or the point that it is.
///
/// Error: t is the exact time for a radius that differs by at most 16 eps L, L being the distance of the
/// centre from the triangle's corners + the longest side + |V| + r, wherever the origin is. So its error is
/// at most 16 eps L / |N.V|, or sqrt(32 eps L r) / |V| when the sphere only grazes; and a sphere that goes as
/// deep as that is never missed. A point, r = 0, cannot go deep: at the time of contact it is within 16 eps L
/// of the triangle, and it is never missed if it passes inside all sides, from before the plane to behind it,
/// all by more than that.
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Triangle& triangle);

}  // namespace first_contact
