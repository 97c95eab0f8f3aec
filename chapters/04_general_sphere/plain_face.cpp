#include "plain_face.hpp"

#include "first_contact/geometry/products.hpp"

using namespace first_contact;

namespace general_sphere_chapter {

//! [plain_face]
std::optional<double> plain_face(const Moving<Sphere>& ball, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector normal = normalized((b - a).cross(c - a));
  const double gap = dot(normal, ball.shape.center - a) - ball.shape.radius;
  const double approach = dot(normal, ball.displacement);
  const double t = -gap / approach;  // chapter 1
  if (gap < 0 || approach >= 0 || t > 1) return std::nullopt;

  const Point foot = ball.shape.center + t * ball.displacement - ball.shape.radius * normal;
  const auto is_left_of = [&](const Point& from, const Point& to) {
    return dot(normal, (to - from).cross(foot - from)) >= 0;
  };
  if (!is_left_of(a, b) || !is_left_of(b, c) || !is_left_of(c, a)) return std::nullopt;
  return t;
}
//! [plain_face]

}  // namespace general_sphere_chapter
