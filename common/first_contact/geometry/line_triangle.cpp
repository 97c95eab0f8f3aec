#include "first_contact/geometry/line_triangle.hpp"

#include "first_contact/geometry/unit_scale.hpp"

namespace first_contact {

namespace {

/// Twice the signed area of the triangle of p, q and the origin. Rounding keeps the order of the two
/// products, so the sign is never wrong: at worst it is 0, and 0 counts as inside.
double area(const Vector2& p, const Vector2& q) { return p.x() * q.y() - p.y() * q.x(); }

}  // namespace

//! [line_meets_triangle]
std::optional<Vector> weights_where_line_meets(const Vector& direction, const Vector& a, const Vector& b,
                                               const Vector& c) {
  // Look along the line: its longest axis is the depth, and a shear moves the line onto it.
  Eigen::Index z = 0;
  const double depth = direction.cwiseAbs().maxCoeff(&z);
  if (!(depth > 0)) return std::nullopt;
  const Eigen::Index x = (z + 1) % 3, y = (z + 2) % 3;
  const auto flatten = [&](const Vector& p) {
    return Vector2(p[x] - direction[x] / direction[z] * p[z], p[y] - direction[y] / direction[z] * p[z]);
  };
  const Vector2 p = flatten(a), q = flatten(b), r = flatten(c);

  const Vector areas(area(q, r), area(r, p), area(p, q));
  const bool inside = (areas.array() >= 0).all() || (areas.array() <= 0).all();
  const double sum = areas.x() + areas.y() + areas.z();
  if (!is_ordinary_square(sum))
    if (const double size = largest(a, b, c), unit = unit_scale(size); !is_ordinary(size) && size > 0)
      return weights_where_line_meets(direction, unit * a, unit * b, unit * c);
  if (!inside || sum == 0) return std::nullopt;
  return areas / sum;
}
//! [line_meets_triangle]

std::optional<Vector> weights_where_line_meets(const Point& point, const Vector& direction,
                                               const Triangle& triangle) {
  return weights_where_line_meets(direction, triangle.a - point, triangle.b - point, triangle.c - point);
}

}  // namespace first_contact
