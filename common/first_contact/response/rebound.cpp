#include "first_contact/response/rebound.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

Surface::Surface(double e, double mu) : restitution(e), friction(mu) {
  if (!(e >= 0 && e <= 1)) refuse("restitution", e, "must be in 0 .. 1");
  if (!(mu >= 0) || !std::isfinite(mu)) refuse("friction", mu, "must be finite and not negative");
}

//! [rebound]
Eigen::Matrix3d rebound(const Vector& motion, const Vector& normal, const Surface& surface) {
  require_finite(motion, "motion");
  const Vector way = normalized(motion);
  const double against = std::max(0.0, -dot(way, normal));
  const double along = norm(way + against * normal);
  const double lost = surface.friction * (1 + surface.restitution) * against;
  const double left = along > lost ? 1 - lost / along : 0;
  const Eigen::Matrix3d across = normal * normal.transpose();
  return left * (Eigen::Matrix3d::Identity() - across) - surface.restitution * across;
}
//! [rebound]

}  // namespace first_contact
