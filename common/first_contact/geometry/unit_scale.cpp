#include "first_contact/geometry/unit_scale.hpp"

#include "first_contact/geometry/products.hpp"

namespace first_contact {

bool within(const Vector& v, double d) {
  const double size = std::max(largest(v), d), unit = is_ordinary(size) ? 1 : unit_scale(size);
  return squared_norm(unit * v) <= unit * d * (unit * d);
}

}  // namespace first_contact
