#include "first_contact/geometry/plane.hpp"

#include <cmath>
#include <sstream>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

//! [plane]
Plane::Plane(const Vector& normal, double offset) {
  const double length = norm(normal);
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(offset / length)) {
    std::ostringstream plane;
    plane << "plane [" << to_text(normal) << ", " << offset << "]";
    refuse(plane.str(),
           "the normal must be finite and not zero, and the offset, divided by its length, finite");
  }
  const Vector unit = normal / length;
  coefficients_ = {unit.x(), unit.y(), unit.z(), offset / length};
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
  return moved;
}
//! [plane_moved_out]

}  // namespace first_contact
