#include "first_contact/geometry/frustum.hpp"

#include <algorithm>

namespace first_contact {

namespace {

// A plane goes by the inverse transpose; the frustum is the image of the cube under the inverse projection,
// so that each face [N, 1] of the cube comes back by the transpose itself.
Plane from_cube(const Transform& projection, double x, double y, double z) {
  const Homogeneous e = projection.matrix().transpose() * Homogeneous(x, y, z, 1);
  return {e.head<3>(), e.w()};
}

}  // namespace

//! [frustum]
Frustum::Frustum(const Transform& projection)
    : planes{from_cube(projection, 1, 0, 0), from_cube(projection, -1, 0, 0),
             from_cube(projection, 0, 1, 0), from_cube(projection, 0, -1, 0),
             from_cube(projection, 0, 0, 1), from_cube(projection, 0, 0, -1)} {}

bool rejected(const Frustum& frustum, const Box& box) {
  return std::any_of(frustum.planes.begin(), frustum.planes.end(), [&](const Plane& e) {
    return e.signed_distance(box.center) < -box.effective_radius(e.normal());
  });
}

bool rejected(const Frustum& frustum, const Sphere& sphere) {
  return std::any_of(frustum.planes.begin(), frustum.planes.end(),
                     [&](const Plane& e) { return e.signed_distance(sphere.center) < -sphere.radius; });
}
//! [frustum]

}  // namespace first_contact
