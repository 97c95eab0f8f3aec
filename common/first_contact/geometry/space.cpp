#include "first_contact/geometry/space.hpp"

#include <cmath>
#include <sstream>

namespace first_contact {

void require_finite(const Vector& value, const std::string& what) {
  if (!value.allFinite()) throw std::invalid_argument(what + " " + to_text(value) + ": must be finite");
}

void require_length(double value, const std::string& what) {
  if (std::isfinite(value) && value >= 0) return;
  std::ostringstream message;
  message << what << " " << value << ": must be finite and not negative";
  throw std::invalid_argument(message.str());
}

std::string to_text(const Vector& value) {
  std::ostringstream text;
  text << value.x() << ", " << value.y() << ", " << value.z();
  return text.str();
}

}  // namespace first_contact
