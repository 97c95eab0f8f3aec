#include "first_contact/geometry/space.hpp"

#include <cmath>
#include <sstream>

#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

void require_finite(const Vector& value, const std::string& what) {
  if (!value.allFinite()) refuse(what + " " + to_text(value), "must be finite");
}

void require_length(double value, const std::string& what) {
  if (!std::isfinite(value) || value < 0) refuse(what, value, "must be finite and not negative");
}

std::string to_text(const Vector& value) {
  std::ostringstream text;
  text << value.x() << ", " << value.y() << ", " << value.z();
  return text.str();
}

}  // namespace first_contact
