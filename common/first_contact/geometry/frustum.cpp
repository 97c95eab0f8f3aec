#include "first_contact/geometry/frustum.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/products.hpp"

namespace first_contact {

namespace {

Plane plane_of(const Homogeneous& e) { return {e.head<3>(), e.w()}; }

// A plane goes by the inverse transpose; the frustum is the image of the cube under the inverse projection,
// so that each face [N, 1] of the cube comes back by the transpose itself.
Plane from_cube(const Transform& projection, double x, double y, double z) {
  const Homogeneous e = product(projection.matrix().transpose(), Homogeneous(x, y, z, 1));
  return plane_of(e);
}

// E.Q < -reach, by more than rounding may be.
bool behind(const Plane& e, const Point& q, double reach) {
  const double rounding = rounding_of_rejection * (std::abs(q.x()) + std::abs(q.y()) + std::abs(q.z()) +
                                                   std::abs(e.offset()) + reach);
  return e.signed_distance(q) + reach < -rounding;
}

}  // namespace

//! [frustum]
Frustum::Frustum(const Transform& projection)
    : planes{from_cube(projection, 1, 0, 0), from_cube(projection, -1, 0, 0),
             from_cube(projection, 0, 1, 0), from_cube(projection, 0, -1, 0),
             from_cube(projection, 0, 0, 1), plane_of(projection.far_side())} {}

bool rejected(const Frustum& frustum, const Box& box) {
  return std::any_of(frustum.planes.begin(), frustum.planes.end(),
                     [&](const Plane& e) { return behind(e, box.center, box.effective_radius(e.normal())); });
}

bool rejected(const Frustum& frustum, const Sphere& sphere) {
  return std::any_of(frustum.planes.begin(), frustum.planes.end(),
                     [&](const Plane& e) { return behind(e, sphere.center, sphere.radius); });
}
//! [frustum]

}  // namespace first_contact
