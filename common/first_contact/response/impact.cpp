#include "first_contact/response/impact.hpp"

#include <cmath>

#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

template <int Dimension>
Body<Dimension>::Body(double m, const Velocity& v) : mass(m), velocity(v) {
  if (!(mass > 0)) refuse("mass", mass, "must be positive");
  if (!velocity.allFinite()) refuse("velocity", "must be finite");
}

//! [impact]
template <int Dimension>
Impact<Dimension> impact(const Body<Dimension>& p, const Body<Dimension>& q,
                         const Eigen::Matrix<double, Dimension, 1>& normal, double restitution) {
  if (!(restitution >= 0 && restitution <= 1)) refuse("restitution", restitution, "must be in 0 .. 1");
  const double n2 = normal.squaredNorm();
  if (!(n2 > 0) || !std::isfinite(n2)) refuse("normal", "must be finite and not zero");

  const double approach = (p.velocity - q.velocity).dot(normal);
  if (!(approach < 0)) return {p.velocity, q.velocity, 0 * normal};

  // Masses act by their inverses, so that 0 can stand for a body that nothing moves.
  const double inverse_p = 1 / p.mass, inverse_q = 1 / q.mass;
  if (inverse_p + inverse_q == 0) refuse("masses", "at most one may be infinite");
  const double impulse = -(1 + restitution) * approach / (n2 * (inverse_p + inverse_q));
  return {p.velocity + (impulse * inverse_p) * normal, q.velocity - (impulse * inverse_q) * normal,
          impulse * normal};
}
//! [impact]

template struct Body<2>;
template struct Body<3>;
template Impact<2> impact(const Body<2>&, const Body<2>&, const Eigen::Vector2d&, double);
template Impact<3> impact(const Body<3>&, const Body<3>&, const Eigen::Vector3d&, double);

}  // namespace first_contact
