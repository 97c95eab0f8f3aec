#include "first_contact/sweep/box_mesh.hpp"

#include <utility>

#include "first_contact/geometry/bounds.hpp"
#include "first_contact/sweep/separating_axes.hpp"

namespace first_contact {

namespace {

/// Around all that the box passes, moved out so that rounding loses nothing.
Bounds passed(const Moving<Box>& moving) {
  Bounds bounds;
  for (const Point& vertex : moving.shape.vertices()) {
    bounds.extend(vertex);
    bounds.extend(vertex + moving.displacement);
  }
  return grown(bounds, rounding_of_projection * largest_coordinate(bounds));
}

}  // namespace

bool overlap(const Box& box, const Triangle& triangle) { return overlap(Hull(box), Hull(triangle)); }

bool overlap(const Box& box, const Mesh& mesh) {
  const Bounds around = passed({box, Vector::Zero()});
  const Hull hull(box);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Triangle triangle = mesh.triangle(i);
    if (overlap(bounds_of(triangle), around) && overlap(hull, Hull(triangle))) return true;
  }
  return false;
}

std::optional<Contact> sweep(const Moving<Box>& moving, const Triangle& triangle) {
  return sweep_hull(Hull(moving.shape), moving.displacement, Hull(triangle));
}

std::optional<Contact> sweep(const Moving<Box>& moving, const Environment& environment) {
  const Hull hull(moving.shape);
  const Bounds around = passed(moving);
  std::optional<Contact> first;
  for (std::size_t i = 0; i < environment.mesh().size(); ++i) {
    const Triangle triangle = environment.mesh().triangle(i);
    if (!overlap(bounds_of(triangle), around)) continue;
    auto contact = sweep_hull(hull, moving.displacement, Hull(triangle));
    if (!contact) continue;
    contact->triangle = i;
    const auto key = [](const Contact& c) { return std::pair(c.time, c.feature); };
    if (!first || key(*contact) < key(*first)) first = contact;
  }
  return first;
}

}  // namespace first_contact
