// stands for: first_contact/sweep/sphere_plane.cpp
// The student's exercise 1b in the place of the library's sweep: ./course run plane --mine
#include "workbook/mine.hpp"

#include <cmath>

#include "first_contact/sweep/sphere_plane.hpp"

namespace mine {
#include "01_plane/exercises/1b/answer.hpp"
}

namespace first_contact {

bool overlap(const Sphere& sphere, const Plane& plane) {
  return std::abs(plane.signed_distance(sphere.center)) <= sphere.radius;
}

std::optional<Contact> sweep(const Moving<Sphere>& moving, const Plane& plane) {
  const auto& [center, radius] = moving.shape;
  const std::optional<double> t = mine::first_contact(mine::plane(plane), mine::vector(center),
                                                      mine::vector(moving.displacement), radius);
  if (!t) return std::nullopt;
  const double distance = plane.signed_distance(center);
  const Vector normal = std::copysign(1.0, distance) * plane.normal();
  return Contact{*t, only(center + *t * moving.displacement - std::min(radius, std::abs(distance)) * normal),
                 normal, Feature::face};
}

}  // namespace first_contact
