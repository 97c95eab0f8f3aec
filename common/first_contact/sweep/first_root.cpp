#include "first_contact/sweep/first_root.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/products.hpp"

namespace first_contact {

//! [first_root]
std::optional<Entry> first_root(const Vector& m, const Vector& v, double r, double tolerance) {
  const double a = squared_norm(v);
  const double b = dot(m, v);
  const double c = squared_norm(m) - r * r;
  if (m.isZero(0) && a > 0) return Entry{0, -normalized(v)};
  if (!(b < 0)) return std::nullopt;           // leaving, sliding along, or at rest
  if (c <= 0) return Entry{0, normalized(m)};  // inside already, and going deeper

  const Vector moment = m.cross(v);  // |m x v| = |v| times the closest approach
  const double slack = a * tolerance * (2 * r + tolerance);
  double discriminant = a * r * r - squared_norm(moment);
  if (!(discriminant >= -slack)) return std::nullopt;
  // Not after the closest approach: of a point that starts on the ball and goes along it, b, c and D are but rounding.
  const double closest = -b / a;
  const double t = discriminant < 0 ? closest : std::min(c / (-b + std::sqrt(discriminant)), closest);
  if (!(t <= 1)) return std::nullopt;

  // From the closest approach, go back along the path by half the chord.
  const Vector arrival = v.cross(moment) / a - std::sqrt(std::max(0.0, discriminant)) / a * v;
  return Entry{t, normalized(r > 0 ? arrival : Vector(-v))};
}
//! [first_root]

}  // namespace first_contact
