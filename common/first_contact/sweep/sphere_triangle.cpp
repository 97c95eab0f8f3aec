#include "first_contact/sweep/sphere_triangle.hpp"

#include <algorithm>
#include <array>

#include "first_contact/geometry/closest_point.hpp"
#include "first_contact/geometry/unit_scale.hpp"
#include "first_contact/sweep/moved_out.hpp"
#include "first_contact/sweep/nearest.hpp"

namespace first_contact {

bool overlap(const Sphere& sphere, const Triangle& triangle) {
  const Point& s = sphere.center;  // differences first: they round less, far from the origin
  const Vector a = triangle.a - s, b = triangle.b - s, c = triangle.c - s;
  const double size = std::max(largest(a, b, c), sphere.radius),
               unit = is_ordinary(size) ? 1 : unit_scale(size);
  return within(closest_point(Point::Zero(), unit * a, unit * b, unit * c), unit * sphere.radius);
}

//! [sweep_sphere_triangle]
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Triangle& triangle) {
  const Facet facet(triangle);
  const std::array<Point, 3> corners{triangle.a, triangle.b, triangle.c};
  const bool overlapping = overlap(moving.shape, triangle);

  std::optional<Touch> first;
  // The distance from a triangle first falls and then rises along a straight path: once inside and not going
  // deeper, a sphere does not come back.
  const auto offer = [&](const std::optional<Touch>& touch) {
    if (touch && !(overlapping && touch->time > 0) && (!first || touch->time < first->time)) first = touch;
  };

  offer(touch_face(moving, facet));
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &from = corners[i], &to = corners[(i + 1) % 3];
    const FaceAround inside{&facet, facet.normal.cross(to - from)};
    if (from == to) continue;
    if (const auto touch = touch_edge(moving, from, to)) offer(among_faces(*touch, {&inside, 1}, moving));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const FaceAround inside{&facet, Vector::Zero()};
    const std::array<Vector, 2> sides{corners[(i + 1) % 3] - corners[i], corners[(i + 2) % 3] - corners[i]};
    if (const auto touch = touch_vertex(moving, corners[i]))
      offer(among_edges(*touch, sides, {&inside, 1}, moving));
  }
  if (!first) return std::nullopt;
  return Contact{first->time, only(first->point), first->normal, first->feature};
}
//! [sweep_sphere_triangle]

}  // namespace first_contact
