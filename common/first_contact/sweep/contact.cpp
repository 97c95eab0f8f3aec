#include "first_contact/sweep/contact.hpp"

namespace first_contact {

Point Contact::point() const {
  Point sum = points.col(0);
  for (Eigen::Index i = 1; i < points.cols(); ++i) sum += points.col(i);
  return sum / static_cast<double>(points.cols());
}

}  // namespace first_contact
