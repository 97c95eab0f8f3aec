#include "plain_sweep.hpp"

#include <cmath>
#include <utility>

#include "first_contact/geometry/products.hpp"
#include "plain_face.hpp"

using namespace first_contact;

namespace general_sphere_chapter {

//! [plain_root]
std::optional<double> plain_root(const Vector& m, const Vector& v, double r) {
  const double a = dot(v, v), b = dot(m, v), c = dot(m, m) - r * r;
  const double discriminant = b * b - a * c;
  if (b >= 0 || discriminant < 0) return std::nullopt;  // on its way out, or passing by
  const double t = (-b - std::sqrt(discriminant)) / a;
  if (t < 0 || t > 1) return std::nullopt;
  return t;
}
//! [plain_root]

//! [plain_edge]
std::optional<double> plain_edge(const Moving<Sphere>& ball, const Point& a, const Point& b) {
  const Vector e = b - a, m = ball.shape.center - a, &v = ball.displacement;
  const auto t = plain_root(e.cross(m), e.cross(v), norm(e) * ball.shape.radius);
  if (!t) return std::nullopt;
  const double along = dot(m + *t * v, e);
  if (along < 0 || along > dot(e, e)) return std::nullopt;  // beyond an end
  return t;
}
//! [plain_edge]

//! [plain_triangle]
std::optional<double> plain_triangle(const Moving<Sphere>& ball, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  std::optional<double> first = plain_face(ball, triangle);
  const auto offer = [&](const std::optional<double>& t) {
    if (t && (!first || *t < *first)) first = t;
  };
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    offer(plain_edge(ball, from, to));
    offer(plain_root(ball.shape.center - from, ball.displacement, ball.shape.radius));  // the vertex
  }
  return first;
}
//! [plain_triangle]

}  // namespace general_sphere_chapter
