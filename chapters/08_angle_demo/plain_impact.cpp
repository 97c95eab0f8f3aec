#include "plain_impact.hpp"

#include "first_contact/geometry/products.hpp"

using namespace first_contact;

namespace angle_demo_chapter {

//! [plain_impact]
std::pair<Vector, Vector> plain_impact(const Body<3>& p, const Body<3>& q, const Vector& normal, double e) {
  const double s = dot(p.velocity - q.velocity, normal);
  if (s >= 0) return {p.velocity, q.velocity};  // not approaching
  const double j = -(1 + e) * s / (1 / p.mass + 1 / q.mass);
  return {p.velocity + j / p.mass * normal, q.velocity - j / q.mass * normal};
}
//! [plain_impact]

}  // namespace angle_demo_chapter
