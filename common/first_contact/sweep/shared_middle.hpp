#pragma once
#include <span>
#include <vector>

#include "first_contact/geometry/space.hpp"

namespace first_contact {

/// The vertices that reach farthest along a unit direction, up to the rounding: one, the two of an edge, or
/// those of a face.
std::vector<Point> farthest(std::span<const Point> vertices, const Vector& direction, double rounding);

/// Two convex polyhedra touch along a normal, which points from the second to the first: the middle of the
/// vertex, the piece of an edge or of a face that they share, on the second. The first one's vertices are
/// given before it has moved by `shift`.
Point shared_middle(std::span<const Point> first, const Vector& shift, std::span<const Point> second,
                    const Vector& normal, double rounding);

}  // namespace first_contact
