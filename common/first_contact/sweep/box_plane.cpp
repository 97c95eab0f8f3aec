#include "first_contact/sweep/box_plane.hpp"

#include <cmath>

#include "first_contact/geometry/products.hpp"
#include "first_contact/sweep/sphere_plane.hpp"

namespace first_contact {

bool overlap(const Box& box, const Plane& plane) {
  return std::abs(plane.signed_distance(box.center)) <= box.effective_radius(plane.normal());
}

//! [lowest_vertices]
ContactPoints lowest_vertices(const Box& box, const Vector& normal) {
  ContactPoints points = box.center;
  for (const Vector& axis : {box.r, box.s, box.t}) {
    const double slope = dot(normalized(axis), normal);
    if (std::abs(slope) > parallel_tolerance) {
      points.colwise() -= std::copysign(0.5, slope) * axis;  // down this axis, whatever the others do
    } else if (!axis.isZero(0)) {  // level: both ends, so twice as many; mirrored, to go around a face
      const Eigen::Index n = points.cols();
      points.conservativeResize(Eigen::NoChange, 2 * n);
      points.rightCols(n) = points.leftCols(n).rowwise().reverse().eval();
      points.leftCols(n).colwise() -= 0.5 * axis;
      points.rightCols(n).colwise() += 0.5 * axis;
    }
  }
  return points;
}
//! [lowest_vertices]

//! [sweep_box_plane]
std::optional<Contact> sweep(const Moving<Box>& moving, const Plane& plane) {
  const Box& box = moving.shape;
  const Sphere ball{box.center, box.effective_radius(plane.normal())};  // what the plane feels of the box
  std::optional<Contact> contact = sweep(Moving{ball, moving.displacement}, plane);
  if (!contact) return std::nullopt;

  contact->points = lowest_vertices(box, contact->normal).colwise() + contact->time * moving.displacement;
  for (auto point : contact->points.colwise()) point -= plane.signed_distance(point) * plane.normal();
  const Eigen::Index n = contact->points.cols();
  contact->feature = n == 1 ? Feature::vertex : n == 2 ? Feature::edge : Feature::face;
  return contact;
}
//! [sweep_box_plane]

}  // namespace first_contact
