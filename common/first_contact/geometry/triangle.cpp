#include "first_contact/geometry/triangle.hpp"

namespace first_contact {

Vector Triangle::area_vector() const { return (b - a).cross(c - a); }

}  // namespace first_contact
