#pragma once
#include <span>

#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/sphere.hpp"

namespace first_contact {

/// The smallest box with its sides along x, y and z that holds all points, to within rounding (paper, 1.1).
/// \throws std::invalid_argument if there is no point, or one is out of range, or what bounds them is (\see Box,
/// Sphere).
Box bounding_box(std::span<const Point> points);

/// A box around all points that is turned the way they spread: along the principal axes of their scatter.
/// Tighter than the upright box for long, slanted shapes; not always the smallest (Ericson, Real-Time
/// Collision Detection, 4.4.3).
/// \throws std::invalid_argument as bounding_box.
Box principal_box(std::span<const Point> points);

/// The smallest sphere that holds all points, by Welzl's method (1991): a point outside the sphere so far is
/// on the rim of the next one, and four points fix it. No point is outside: |P - C| <= r in double precision.
/// The radius is too large by at most 1e-9 of itself + 2 eps of the largest coordinate: the centre's own
/// coordinates are doubles, which lie wide apart where they are large.
/// \throws std::invalid_argument as bounding_box.
Sphere bounding_sphere(std::span<const Point> points);

/// The volume of a box, in the cube of the caller's unit; infinite or 0 if no double is so large or so small.
double volume(const Box& box);
/// The volume of a sphere, likewise.
double volume(const Sphere& sphere);

}  // namespace first_contact
