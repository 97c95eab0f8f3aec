#pragma once
#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

/// The point of the segment ab that is nearest to `point` (Ericson, Real-Time Collision Detection, 5.1.2).
/// If a = b, that is a.
Point closest_point(const Point& point, const Point& a, const Point& b);

/// The point of a triangle that is nearest to `point`: the foot of the perpendicular, if it is inside, or
/// else the nearest point of the three sides. The triangle may be degenerate.
Point closest_point(const Point& point, const Point& a, const Point& b, const Point& c);
/// The point of a triangle that is nearest to `point`.
inline Point closest_point(const Point& point, const Triangle& triangle) {
  return closest_point(point, triangle.a, triangle.b, triangle.c);
}

}  // namespace first_contact
