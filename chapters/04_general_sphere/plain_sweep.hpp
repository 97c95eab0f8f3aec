#pragma once
#include <optional>

#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"
#include "first_contact/sweep/moving.hpp"

/// The rest of a ball against a triangle, as one writes it first: right for ordinary triangles and for balls
/// that start outside, not far away, and come from the side of the normal.

namespace general_sphere_chapter {

/// When m + t v, for t from 0 to 1, enters the sphere of radius r about the origin; nothing if it does not.
/// From far away the discriminant is rounding.
std::optional<double> plain_root(const first_contact::Vector& m, const first_contact::Vector& v, double r);

/// When the ball touches the edge from a to b between its ends; nothing if it does not.
std::optional<double> plain_edge(const first_contact::Moving<first_contact::Sphere>& ball,
                                 const first_contact::Point& a, const first_contact::Point& b);

/// When the ball touches the triangle, wherever; nothing if it does not.
std::optional<double> plain_triangle(const first_contact::Moving<first_contact::Sphere>& ball,
                                     const first_contact::Triangle& triangle);

}  // namespace general_sphere_chapter
