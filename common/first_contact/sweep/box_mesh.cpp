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

/// A hull about the origin stands for the box; both are seen from a corner of the triangle.
bool overlap(const Hull& box, const Point& center, const Triangle& triangle) {
  return overlap(seen_from(triangle.a - center, box), seen_from(triangle.a, Hull(triangle)));
}
std::optional<Contact> sweep(const Hull& box, const Moving<Box>& moving, const Triangle& triangle) {
  auto contact = sweep_hull(seen_from(triangle.a - moving.shape.center, box), moving.displacement,
                            seen_from(triangle.a, Hull(triangle)));
  if (contact) contact->points.colwise() += triangle.a;
  return contact;
}

}  // namespace

bool overlap(const Box& box, const Triangle& triangle) {
  return overlap(about_origin(box), box.center, triangle);
}

bool overlap(const Box& box, const Mesh& mesh) {
  const Bounds around = passed({box, Vector::Zero()});
  const Hull hull = about_origin(box);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Triangle triangle = mesh.triangle(i);
    if (overlap(bounds_of(triangle), around) && overlap(hull, box.center, triangle)) return true;
  }
  return false;
}

std::optional<Contact> sweep(const Moving<Box>& moving, const Triangle& triangle) {
  return sweep(about_origin(moving.shape), moving, triangle);
}

std::optional<Contact> sweep(const Moving<Box>& moving, const Environment& environment) {
  const Hull hull = about_origin(moving.shape);
  const Bounds around = passed(moving);
  std::optional<Contact> first;
  for (std::size_t i = 0; i < environment.mesh().size(); ++i) {
    const Triangle triangle = environment.mesh().triangle(i);
    if (!overlap(bounds_of(triangle), around)) continue;
    auto contact = sweep(hull, moving, triangle);
    if (!contact) continue;
    contact->triangle = i;
    const auto key = [](const Contact& c) { return std::pair(c.time, c.feature); };
    if (!first || key(*contact) < key(*first)) first = contact;
  }
  return first;
}

}  // namespace first_contact
