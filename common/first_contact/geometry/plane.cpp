#include "first_contact/geometry/plane.hpp"

#include <cmath>
#include <sstream>

#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

//! [plane]
Plane::Plane(const Vector& normal, double offset) {
  const double length = normal.stableNorm();
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(offset / length)) {
    std::ostringstream plane;
    plane << "plane [" << to_text(normal) << ", " << offset << "]";
    refuse(plane.str(),
           "the normal must be finite and not zero, and the offset, divided by its length, finite");
  }
  coefficients_ << normal / length, offset / length;
}
//! [plane]

//! [plane_through]
Plane Plane::through(const Point& point, const Vector& normal) { return {normal, -normal.dot(point)}; }
//! [plane_through]

//! [plane_moved_out]
Plane Plane::moved_out(double distance) const {
  Plane moved = *this;
  moved.coefficients_.w() -= distance;
  return moved;
}
//! [plane_moved_out]

}  // namespace first_contact
