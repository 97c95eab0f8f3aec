#include "first_contact/geometry/space.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

// Between these no square that matters has left the range of ordinary numbers.
bool is_ordinary(double square) { return square > 0x1p-900 && square < 0x1p900; }

}  // namespace

double norm(const Vector& v) {
  const double square = squared_norm(v);
  if (is_ordinary(square) || !v.allFinite()) return std::sqrt(square);
  const double unit = unit_scale(v.cwiseAbs().maxCoeff());
  return std::sqrt(squared_norm(unit * v)) / unit;
}

Vector normalized(const Vector& v) {
  const double square = squared_norm(v);
  if (is_ordinary(square)) return v / std::sqrt(square);
  if (!v.allFinite() || v.isZero(0)) return v;
  const Vector moderate = unit_scale(v.cwiseAbs().maxCoeff()) * v;
  return moderate / std::sqrt(squared_norm(moderate));
}

double lerp(double a, double b, double t) {
  if ((a <= 0 && b >= 0) || (a >= 0 && b <= 0)) return t * b + (1 - t) * a;  // no difference that overflows
  if (t == 1) return b;
  const double x = a + t * (b - a);
  return (t > 1) == (b > a) ? std::max(b, x) : std::min(b, x);
}

void require_finite(const Vector& value, const std::string& what) {
  if (!value.allFinite()) refuse(what + " " + to_text(value), "must be finite");
}

void require_length(double value, const std::string& what) {
  if (!std::isfinite(value) || value < 0) refuse(what, value, "must be finite and not negative");
}

std::string to_text(const Vector& value) {
  std::ostringstream text;
  text << value.x() << ", " << value.y() << ", " << value.z();
  return text.str();
}

}  // namespace first_contact
