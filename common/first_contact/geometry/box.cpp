#include "first_contact/geometry/box.hpp"

#include <cmath>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"

namespace first_contact {

namespace {

void require_perpendicular(const Vector& a, const Vector& b, const std::string& names) {
  if (std::abs(dot(normalized(a), normalized(b))) <= Box::perpendicular_tolerance) return;
  refuse("box's axes " + names + " (" + to_text(a) + ") and (" + to_text(b) + ")", "must be perpendicular");
}

}  // namespace

Box::Box(const Point& q, const Vector& along_r, const Vector& along_s, const Vector& along_t)
    : center(q), r(along_r), s(along_s), t(along_t) {
  require_finite(center, "box's centre");
  require_finite(r, "box's axis R");
  require_finite(s, "box's axis S");
  require_finite(t, "box's axis T");
  require_perpendicular(r, s, "R, S");
  require_perpendicular(s, t, "S, T");
  require_perpendicular(t, r, "T, R");
  require_length(norm(r) + norm(s) + norm(t), "box's lengths together");
}

//! [effective_radius]
double Box::effective_radius(const Vector& unit) const {
  return 0.5 * (std::abs(dot(r, unit)) + std::abs(dot(s, unit)) + std::abs(dot(t, unit)));
}
//! [effective_radius]

std::array<Point, 8> Box::vertices() const {
  std::array<Point, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const double sign_r = (i & 1U) ? 0.5 : -0.5;
    const double sign_s = (i & 2U) ? 0.5 : -0.5;
    const double sign_t = (i & 4U) ? 0.5 : -0.5;
    corners[i] = center + sign_r * r + sign_s * s + sign_t * t;
  }
  return corners;
}

}  // namespace first_contact
