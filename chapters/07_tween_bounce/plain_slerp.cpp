#include "plain_slerp.hpp"

#include <cmath>

#include "first_contact/geometry/products.hpp"
#include "first_contact/program/random.hpp"

using namespace first_contact;

namespace tween_bounce {

//! [plain_slerp]
Quaternion plain_slerp(const Quaternion& a, const Quaternion& b, double s) {
  const double omega = std::acos(dot(a.coeffs(), b.coeffs()));
  const double of_a = std::sin((1 - s) * omega) / std::sin(omega);
  const double of_b = std::sin(s * omega) / std::sin(omega);
  return Quaternion(Homogeneous(of_a * a.coeffs() + of_b * b.coeffs()));
}
//! [plain_slerp]

int lost_at_rest(int bodies) {
  program::Random random(1);
  int lost = 0;
  for (int i = 0; i < bodies; ++i) {
    const Vector v = random.vector();
    Quaternion a(random.number(), v.x(), v.y(), v.z());
    a.coeffs() /= norm(a);
    lost += !plain_slerp(a, a, 0.5).coeffs().allFinite();
  }
  return lost;
}

}  // namespace tween_bounce
