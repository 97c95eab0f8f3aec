#pragma once
#include <cmath>
#include <concepts>

#include "first_contact/geometry/box.hpp"
#include "first_contact/geometry/mesh.hpp"
#include "first_contact/geometry/plane.hpp"
#include "first_contact/geometry/sphere.hpp"
#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

/// The largest coordinate that describes a thing, without its sign: what the rounding of its coordinates is
/// relative to. Whose own type is to be slid along writes such a function beside it.
inline double largest_coordinate(const Plane& plane) { return std::abs(plane.offset()); }
/// Of a sphere: of its centre, and the radius.
double largest_coordinate(const Sphere& sphere);
/// Of a box: of its eight vertices.
double largest_coordinate(const Box& box);
/// Of a triangle: of its three corners.
double largest_coordinate(const Triangle& triangle);
/// Of a mesh: of all its vertices. It is kept, not looked for.
inline double largest_coordinate(const Mesh& mesh) { return mesh.largest_coordinate(); }

/// Of whatever knows the mesh that it is made of: an environment, a tree.
template <class Surface>
requires requires(const Surface& surface) {
  { surface.mesh() } -> std::same_as<const Mesh&>;
}
double largest_coordinate(const Surface& surface) { return surface.mesh().largest_coordinate(); }

}  // namespace first_contact
