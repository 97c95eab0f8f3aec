#include "first_contact/geometry/space.hpp"

#include <algorithm>
#include <cmath>

#include "first_contact/geometry/number_text.hpp"
#include "first_contact/geometry/products.hpp"
#include "first_contact/geometry/refuse.hpp"
#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

double norm(const Vector& v) {
  const double square = squared_norm(v);
  if (is_ordinary_square(square) || !v.allFinite()) return std::sqrt(square);
  const double unit = unit_scale(largest(v));
  return std::sqrt(squared_norm(unit * v)) / unit;
}

Vector normalized(const Vector& v) {
  const double square = squared_norm(v);
  if (is_ordinary_square(square)) return v / std::sqrt(square);
  if (!v.allFinite() || v.isZero(0)) return v;
  const Vector moderate = unit_scale(largest(v)) * v;
  return moderate / std::sqrt(squared_norm(moderate));
}

Point mean(std::span<const Point> points) {
  Point sum = Point::Zero();
  for (const Point& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

double lerp(double a, double b, double t) {
  if ((a <= 0 && b >= 0) || (a >= 0 && b <= 0)) return t * b + (1 - t) * a;  // no difference that overflows
  if (t == 1) return b;
  const double x = a + t * (b - a);
  return (t > 1) == (b > a) ? std::max(b, x) : std::min(b, x);
}

void require_finite(const Vector& value, const std::string& what) {
  if (!in_range(value)) refuse(what + " " + to_text(value), "must be finite, and at most 1.07e301 (2^1000)");
}

void require_length(double value, const std::string& what) {
  if (!(value >= 0 && value <= largest_length))
    refuse(what, value, "must be finite and not negative, and at most 1.07e301 (2^1000)");
}

std::string to_text(const Vector& value) {
  return to_text(value.x()) + ", " + to_text(value.y()) + ", " + to_text(value.z());
}

}  // namespace first_contact
