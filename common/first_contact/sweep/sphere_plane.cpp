#include "first_contact/sweep/sphere_plane.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/products.hpp"

namespace first_contact {

//! [overlap_sphere_plane]
bool overlap(const Sphere& sphere, const Plane& plane) {
  return std::abs(plane.signed_distance(sphere.center)) <= sphere.radius;
}
//! [overlap_sphere_plane]

//! [sweep_sphere_plane]
std::optional<Contact> sweep(const Moving<Sphere>& moving, const Plane& plane) {
  const auto& [center, radius] = moving.shape;
  const double distance = plane.signed_distance(center);  // E.S0
  const double toward = dot(plane.normal(), moving.displacement);

  // A plane has two sides: work on the one where the centre is. A centre on the plane has none: against the
  // motion.
  const double side = distance != 0 ? std::copysign(1.0, distance) : -std::copysign(1.0, toward);
  const Vector normal = side * plane.normal();
  const double gap = std::abs(distance) - radius;  // E'.S0
  const double approach = side * toward;           // N.V
  if (!(approach < 0)) return std::nullopt;        // sliding along, leaving, or at rest

  const double t = std::max(0.0, -gap / approach);  // overlapping and going deeper: now
  if (!(t <= 1)) return std::nullopt;               // not within this motion
  const Point touching = center + t * moving.displacement;
  const double reach = std::min(radius, std::abs(distance));  // overlapping: only as far as the plane
  return Contact{t, only(touching - reach * normal), normal, Feature::face};
}
//! [sweep_sphere_plane]

}  // namespace first_contact
