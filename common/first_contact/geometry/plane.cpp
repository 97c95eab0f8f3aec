#include "first_contact/geometry/plane.hpp"

#include <cmath>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

//! [plane]
Plane::Plane(const Vector& normal, double offset) {
  const double unit = is_ordinary(largest(normal)) ? 1 : unit_scale(largest(normal));
  const Vector n = unit * normal;
  const double length = norm(n), distance = unit * offset / length;
  if (!(length > 0) || !std::isfinite(length) || !(std::abs(distance) <= 2 * largest_length)) {
    refuse(
        "plane [" + to_text(normal) + ", " + to_text(offset) + "]",
        "the normal must be finite and not zero, and the offset, divided by its length, finite and at most "
        "2.1e301 (2^1001)");
  }
  coefficients_ = {n.x() / length, n.y() / length, n.z() / length, distance};
}
//! [plane]

//! [plane_through]
Plane Plane::through(const Point& point, const Vector& normal) { return {normal, -dot(normal, point)}; }
//! [plane_through]

double Plane::signed_distance(const Point& q) const { return dot(coefficients_, as_point(q)); }

//! [plane_moved_out]
Plane Plane::moved_out(double distance) const {
  Plane moved = *this;
  moved.coefficients_.w() -= distance;
  if (!(std::abs(moved.offset()) <= 4 * largest_length))
    refuse("plane moved out by", distance, "must be no farther from the origin than 4.29e301 (2^1002)");
  return moved;
}
//! [plane_moved_out]

}  // namespace first_contact
