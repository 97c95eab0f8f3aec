#include "first_contact/sweep/ray_triangle.hpp"

#include <cmath>

#include "first_contact/geometry/facet.hpp"
#include "first_contact/geometry/line_triangle.hpp"
#include "first_contact/sweep/sphere_triangle.hpp"

namespace first_contact {

//! [sweep_ray_triangle]
std::optional<Contact> sweep(const Moving<Point>& moving, const Triangle& triangle) {
  const Point& start = moving.shape;
  const Facet facet(triangle);
  const double height = facet.normal.dot(start - facet.corner);  // |n| E.S0
  const double toward = facet.normal.dot(moving.displacement);   // |n| N.V
  const double t = -height / toward;
  if (t > 0 && t <= 1 && weights_where_line_meets(start, moving.displacement, triangle)) {
    const Vector normal = std::copysign(1.0, height) * facet.unit_normal();
    return Contact{t, start + t * moving.displacement, normal, Feature::face};
  }
  return sweep(Moving<Sphere>{{start, 0}, moving.displacement},
               triangle);  // in the plane, or past the triangle
}
//! [sweep_ray_triangle]

}  // namespace first_contact
