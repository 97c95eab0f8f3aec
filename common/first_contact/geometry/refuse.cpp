#include "first_contact/geometry/refuse.hpp"

#include <sstream>
#include <stdexcept>

namespace first_contact {

void refuse(const std::string& what, const std::string& rule) {
  throw std::invalid_argument(what + ": " + rule);
}

void refuse(const std::string& what, double value, const std::string& rule) {
  std::ostringstream text;
  text << what << " " << value;
  refuse(text.str(), rule);
}

}  // namespace first_contact
