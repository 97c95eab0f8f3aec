#pragma once
#include <optional>

#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

/// Where the straight line through `point` along `direction` meets a triangle: three weights, not negative,
/// of sum 1, so that the meeting point is u a + v b + w c. Nothing if the line passes beside the triangle or
/// lies in its plane.
///
/// Watertight (after Woop, Benthin, Wald: Watertight Ray/Triangle Intersection, JCGT 2(1), 2013): of the
/// triangles around a shared edge or vertex, a line through that edge or vertex meets at least one.
std::optional<Vector> weights_where_line_meets(const Point& point, const Vector& direction,
                                               const Triangle& triangle);

/// The same for corners that are given relative to the line's point.
std::optional<Vector> weights_where_line_meets(const Vector& direction, const Vector& a, const Vector& b,
                                               const Vector& c);

}  // namespace first_contact
