#include "first_contact/sweep/ray_triangle.hpp"

#include "first_contact/sweep/sphere_triangle.hpp"

namespace first_contact {

//! [sweep_ray_triangle]
std::optional<Contact> sweep(const Moving<Point>& moving, const Triangle& triangle) {
  return sweep(Moving<Sphere>{{moving.shape, 0}, moving.displacement}, triangle);
}
//! [sweep_ray_triangle]

}  // namespace first_contact
