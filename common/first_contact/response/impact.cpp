#include "first_contact/response/impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

template <int Dimension>
double fastest(const Body<Dimension>& p, const Body<Dimension>& q) {
  return std::max(p.velocity.cwiseAbs().maxCoeff(), q.velocity.cwiseAbs().maxCoeff());
}

std::string text_of(const auto& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + to_text(number);
  return text;
}

template <int Dimension>
const Impact<Dimension>& finite(const Impact<Dimension>& after) {
  for (const auto& velocity : {after.velocity_p, after.velocity_q})
    if (!velocity.allFinite()) refuse("velocity after the impact, " + text_of(velocity), "must be finite");
  if (!after.impulse.allFinite())
    refuse("impulse, mass times velocity, " + text_of(after.impulse), "must be finite");
  return after;
}

}  // namespace

template <int Dimension>
Body<Dimension>::Body(double m, const Velocity& v) : mass(m), velocity(v) {
  if (!(mass > 0)) refuse("mass", mass, "must be positive");
  if (!velocity.allFinite()) refuse("velocity " + text_of(velocity), "must be finite");
}

//! [impact]
template <int Dimension>
Impact<Dimension> impact(const Body<Dimension>& p, const Body<Dimension>& q,
                         const VectorOf<Dimension>& normal, double restitution) {
  if (!(restitution >= 0 && restitution <= 1)) refuse("restitution", restitution, "must be in 0 .. 1");
  const double size = normal.cwiseAbs().maxCoeff();
  if (!normal.allFinite() || size == 0) refuse("normal " + text_of(normal), "must be finite and not zero");
  const VectorOf<Dimension> n = unit_scale(size) * normal;  // its length does not matter

  const double slower = unit_scale(fastest(p, q));
  const double approach = dot(slower * p.velocity - slower * q.velocity, n);
  if (!(approach < 0)) return {p.velocity, q.velocity, 0 * n};

  // Masses act by their inverses, so that 0 can stand for a body that nothing moves.
  const double lighter = unit_scale(std::min(p.mass, q.mass));
  const double inverse_p = 1 / (lighter * p.mass), inverse_q = 1 / (lighter * q.mass);
  if (inverse_p + inverse_q == 0) refuse("masses", "at most one may be infinite");
  const double impulse = -(1 + restitution) * approach / (squared_norm(n) * (inverse_p + inverse_q));
  return finite<Dimension>({p.velocity + impulse * inverse_p / slower * n,
                            q.velocity - impulse * inverse_q / slower * n, impulse * n / slower / lighter});
}
//! [impact]

template struct Body<2>;
template struct Body<3>;
template Impact<2> impact(const Body<2>&, const Body<2>&, const Vector2&, double);
template Impact<3> impact(const Body<3>&, const Body<3>&, const Vector&, double);

}  // namespace first_contact
