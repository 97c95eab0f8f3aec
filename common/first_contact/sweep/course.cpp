#include "first_contact/sweep/course.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "first_contact/geometry/products.hpp"

namespace first_contact {

// The root of bend t^2 / 2 - rate t - room = 0, in the form that does not cancel.
double time_above(double level, const Course& course) {
  const double room = course.height - level;
  const double root = std::sqrt(course.rate * course.rate + 2 * course.bend * room);
  if (course.rate < 0) return 2 * room / (root - course.rate);
  return course.bend > 0 ? (course.rate + root) / course.bend : std::numeric_limits<double>::infinity();
}

Going::Going(const Turning<Mesh>& turning, double now)
    : hinge_(turning.center + now * turning.displacement),
      axis_(turning.axis),
      angle_(turning.angle),
      displacement_(turning.displacement) {}

double Going::speed_of(std::initializer_list<Point> points) const {
  double reach = 0;
  for (const Point& p : points) reach = std::max(reach, norm(axis_.cross(p - hinge_)));
  return norm(displacement_) + std::abs(angle_) * reach;
}

Course Going::of(const Point& p, const Vector& normal, const Point& base) const {
  const double reach = norm(axis_.cross(p - hinge_)), tilt = norm(axis_.cross(normal));
  return {dot(normal, p - base), dot(normal, velocity(p)), angle_ * angle_ * reach * tilt};
}

}  // namespace first_contact
