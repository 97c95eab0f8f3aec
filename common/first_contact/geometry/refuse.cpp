#include "first_contact/geometry/refuse.hpp"

#include <stdexcept>

#include "first_contact/geometry/number_text.hpp"

namespace first_contact {

void refuse(const std::string& what, const std::string& rule) {
  throw std::invalid_argument(what + ": " + rule);
}

void refuse(const std::string& what, double value, const std::string& rule) {
  refuse(what + " " + to_text(value), rule);
}

}  // namespace first_contact
